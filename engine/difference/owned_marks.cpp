#include "engine/difference/owned_marks.h"

#include <algorithm>

#include "engine/kernel/brep.h"

namespace remeshd {

std::vector<int> OwnedMarks::owned_cells() const {
  std::vector<int> owned;
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (cells[c] != Mark::Absent) owned.push_back(static_cast<int>(c));
  return owned;
}

OwnedMarks owned_marks(const CellComplex& model, const std::vector<int>& features) {
  const auto owns = [&](const std::vector<int>& owners) {
    return std::ranges::any_of(features,
                               [&](int f) { return std::ranges::binary_search(owners, f); });
  };
  const auto mark = [](bool yes) { return yes ? Mark::Yes : Mark::No; };
  OwnedMarks out;
  for (const Cell& cell : model.cells)
    out.cells.push_back(owns(cell.owners) ? mark(cell.positive) : Mark::Absent);
  for (const CellFace& face : model.faces)
    out.faces.push_back(owns(face.owners) ? mark(face.boundary) : Mark::Absent);
  out.edges.assign(model.brep->edges.size(), Mark::Absent);
  for (const CellEdge& edge : model.edges)
    if (owns(edge.owners)) out.edges[edge.element] = mark(edge.boundary);
  out.vertices.assign(model.brep->vertices.size(), Mark::Absent);
  for (const CellVertex& vertex : model.vertices)
    if (owns(vertex.owners)) out.vertices[vertex.element] = mark(vertex.boundary);
  return out;
}

}  // namespace remeshd
