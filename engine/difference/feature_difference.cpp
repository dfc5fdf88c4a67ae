#include "engine/difference/feature_difference.h"

#include <algorithm>

#include "engine/cellular/boundary_model/unified_edges.h"
#include "engine/difference/owned_marks.h"
#include "engine/kernel/brep.h"

namespace remeshd {
namespace {

using kernel::Brep;
using kernel::Fusion;
using kernel::Source;

void add(std::vector<DifferenceElement>& elements, ClassTotals& totals, DifferenceClass value,
         double measure, const Vec3& at) {
  elements.push_back({value, measure, at});
  totals[value] += measure;
}

/// Marks of an element in both models; Absent where the feature does not have it.
struct Marks {
  Mark original = Mark::Absent, modified = Mark::Absent;
  [[nodiscard]] bool none() const { return original == Mark::Absent && modified == Mark::Absent; }
};

/// The parts of an overlay, by number: what the feature owns in a model, and which model that is.
struct Sides {
  const OwnedMarks* part[2] = {nullptr, nullptr};
  bool is_original[2] = {false, false};

  [[nodiscard]] Marks of(const std::vector<Source>& sources,
                         const std::vector<Mark> OwnedMarks::*kind) const {
    Marks marks;
    for (const Source& source : sources) {
      const Mark mark = (part[source.part]->*kind)[source.element];
      Mark& side = is_original[source.part] ? marks.original : marks.modified;
      // Where two elements of one model fell together, being boundary counts.
      if (mark != Mark::Absent) side = std::min(side, mark);
    }
    return marks;
  }
};

void classify_edges_and_vertices(FeatureDifference& out, const Fusion& fusion, const Sides& sides) {
  const Brep& brep = fusion.brep;
  struct End {
    int edge, end;
  };
  std::vector<std::vector<End>> ends(brep.vertices.size());
  for (int e = 0; e < static_cast<int>(brep.edges.size()); ++e) {
    const Marks marks = sides.of(fusion.edges[e], &OwnedMarks::edges);
    // Sources that are no elements: a seam.
    if (marks.none() && !fusion.edges[e].empty()) continue;
    add(out.edges, out.edge_lengths, classify(marks.original, marks.modified), brep.edges[e].length,
        brep.edges[e].middle());
    for (const int end : {0, 1}) ends[brep.edges[e].vertices[end]].push_back({e, end});
  }
  const double tolerance = kernel_tolerance(brep);
  for (std::size_t v = 0; v < brep.vertices.size(); ++v) {
    const Marks marks = sides.of(fusion.vertices[v], &OwnedMarks::vertices);
    if (marks.none()) {
      // Where a seam begins or crosses something, an edge only passes through.
      const bool passes =
          ends[v].size() == 2 && continues(brep.edges[ends[v][0].edge], ends[v][0].end,
                                           brep.edges[ends[v][1].edge], ends[v][1].end, tolerance);
      if (passes || ends[v].empty()) continue;
    }
    add(out.vertices, out.vertex_counts, classify(marks.original, marks.modified), 1,
        brep.vertices[v].position);
  }
}

}  // namespace

Transform to_original(const Feature& original, const Feature& modified) {
  if (original.alignment == modified.alignment) return {};
  return original.alignment * rigid_inverse(modified.alignment);
}

FeatureDifference feature_difference(const std::string& id, const ModelView& original,
                                     const ModelView& modified, const Run& run) {
  run.poll();
  FeatureDifference out;
  out.id = id;
  const int in_original = original.features ? original.features->index_of(id) : -1;
  const int in_modified = modified.features ? modified.features->index_of(id) : -1;
  OwnedMarks original_marks, modified_marks;
  std::vector<kernel::Part> parts;
  Sides sides;
  const auto add_part = [&](const ModelView& view, int feature, OwnedMarks& marks, bool is_original,
                            const Transform& where) {
    if (feature < 0) return;
    const CellComplex& cells = view.cells->complex(run);
    marks = owned_marks(cells, {feature});
    sides.part[parts.size()] = &marks;
    sides.is_original[parts.size()] = is_original;
    parts.push_back({cells.brep.get(), marks.owned_cells(), where});
  };
  add_part(original, in_original, original_marks, true, {});
  Transform where;
  if (in_original >= 0 && in_modified >= 0)
    where = to_original(original.features->features[in_original],
                        modified.features->features[in_modified]);
  add_part(modified, in_modified, modified_marks, false, where);
  if (parts.empty()) return out;

  const Fusion fusion = kernel::general_fuse(parts, run);
  const Brep& brep = fusion.brep;
  for (std::size_t c = 0; c < brep.cells.size(); ++c) {
    const Marks marks = sides.of(fusion.cells[c], &OwnedMarks::cells);
    const int face = brep.cells[c].faces.front();
    add(out.cells, out.cell_volumes, classify(marks.original, marks.modified), brep.cells[c].volume,
        brep.faces[face].centroid);
  }
  for (std::size_t f = 0; f < brep.faces.size(); ++f) {
    const Marks marks = sides.of(fusion.faces[f], &OwnedMarks::faces);
    add(out.faces, out.face_areas, classify(marks.original, marks.modified), brep.faces[f].area,
        brep.faces[f].centroid);
  }
  classify_edges_and_vertices(out, fusion, sides);
  return out;
}

std::vector<FeatureDifference> difference_model(const ModelView& original,
                                                const ModelView& modified, const Run& run) {
  std::vector<FeatureDifference> differences;
  for (const Feature& feature : modified.features->features)
    differences.push_back(feature_difference(feature.id, original, modified, run));
  for (const Feature& feature : original.features->features)
    if (modified.features->index_of(feature.id) < 0)
      differences.push_back(feature_difference(feature.id, original, modified, run));
  return differences;
}

}  // namespace remeshd
