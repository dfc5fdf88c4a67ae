#include "engine/cellular/cellular_model.h"

#include <algorithm>
#include <map>
#include <mutex>

#include "engine/base/error.h"
#include "engine/base/union_find.h"
#include "engine/cellular/boundary_model/build_boundary.h"
#include "engine/cellular/boundary_model/group_rims.h"
#include "engine/cellular/boundary_model/unified_edges.h"
#include "engine/cellular/features_at.h"
#include "engine/cellular/fuse_features.h"
#include "engine/cellular/owners.h"
#include "engine/cellular/point_contact.h"
#include "engine/kernel/brep.h"
#include "engine/model/solid.h"

namespace remeshd {

/// The cells of a model, or the model to make them from when they are first asked for.
class ComplexOnDemand {
 public:
  explicit ComplexOnDemand(CellComplex made) : made_(std::move(made)) {}
  explicit ComplexOnDemand(FeatureModel model) : model_(std::move(model)) {}

  const CellComplex& get(const Run& run) const {
    const std::scoped_lock lock(mutex_);
    if (!made_) made_ = build_cells(model_, run).complex(run);
    return *made_;
  }

 private:
  mutable std::mutex mutex_;
  mutable std::optional<CellComplex> made_;
  FeatureModel model_;
};

namespace {

using kernel::Brep;

/// A part of the model's material that shares no face with the rest.
struct Piece {
  double volume = 0;
  int largest = -1;           ///< index of its largest cell
  std::vector<int> features;  ///< owners of its cells
};

/// Throws Error(EMPTY_MODEL, DISCONNECTED_MODEL); the latter names the smallest piece.
void require_one_piece(const CellComplex& model, const FeatureModel& features) {
  UnionFind piece(model.cells.size());
  for (const CellFace& face : model.faces)
    if (face.cells[0] >= 0 && face.cells[1] >= 0 && model.cells[face.cells[0]].positive &&
        model.cells[face.cells[1]].positive)
      piece.join(face.cells[0], face.cells[1]);
  std::map<int, Piece> pieces;
  for (int c = 0; c < static_cast<int>(model.cells.size()); ++c) {
    const Cell& cell = model.cells[c];
    if (!cell.positive) continue;
    Piece& p = pieces[piece.find(c)];
    p.volume += cell.volume;
    if (p.largest < 0 || cell.volume > model.cells[p.largest].volume) p.largest = c;
    merge_owners(p.features, cell.owners);
  }
  if (pieces.empty()) throw error::empty_model();
  if (pieces.size() == 1) return;
  const Piece& smallest =
      std::ranges::min_element(pieces, {}, [](const auto& p) { return p.second.volume; })->second;
  throw error::disconnected_model(static_cast<int>(pieces.size()),
                                  model.cells[smallest.largest].inside,
                                  ids_of(features, smallest.features));
}

void fill_edges_and_vertices(CellComplex& out, const Brep& brep, const UnifiedEdges& all,
                             const UnifiedEdges& boundary) {
  std::vector<std::vector<int>> vertex_owners(brep.vertices.size());
  for (int e = 0; e < static_cast<int>(brep.edges.size()); ++e) {
    CellEdge edge{{}, boundary.edge[e] != 0, brep.edges[e].length, e};
    for (const int f : all.faces_at_edge[e]) merge_owners(edge.owners, out.faces[f].owners);
    for (const int v : brep.edges[e].vertices) merge_owners(vertex_owners[v], edge.owners);
    if (all.edge[e]) out.edges.push_back(std::move(edge));
  }
  for (int v = 0; v < static_cast<int>(brep.vertices.size()); ++v)
    if (all.vertex[v])
      out.vertices.push_back(
          {vertex_owners[v], boundary.vertex[v] != 0, brep.vertices[v].position, v});
}

/// Joins the boundary of a model from its parts.
///
/// Throws Error(NON_MANIFOLD_MODEL).
CellularModel join_boundary(BoundaryParts parts, const FeatureModel& model,
                            const Membership& membership) {
  CellularModel out;
  const Brep& brep = parts.brep;
  const UnifiedEdges unified = unified_edges_of(brep, parts.pieces, model);
  require_manifold(brep, unified);
  if (const auto contact = find_point_contact(membership, 0.1 * kernel_tolerance(brep)))
    throw error::non_manifold_model("at a point", *contact, {});
  out.boundary = build_boundary(brep, parts.pieces, unified);
  for (const kernel::BrepFace& face : brep.faces) {
    out.area += face.area;
    out.volume += face.swept_volume;
  }
  out.scale = brep.scale;
  out.parts = std::make_shared<const BoundaryParts>(std::move(parts));
  return out;
}

}  // namespace

const CellComplex& CellularModel::complex(const Run& run) const { return on_demand->get(run); }

CellularModel build_cells(const FeatureModel& model, const Run& run) {
  run.poll();
  const Membership membership(model);
  CellularModel out;
  fuse_features(model, membership, fuse_frame(membership), run, [&](FusedFeatures fused) {
    const Brep& brep = *fused.cells.brep;
    require_one_piece(fused.cells, model);
    BoundaryParts parts = boundary_parts(brep, fused.pieces);
    parts.geometry = "fused";
    out = join_boundary(std::move(parts), model, membership);
    fill_edges_and_vertices(fused.cells, brep, unified_edges_of(brep, fused.pieces, model, true),
                            unified_edges_of(brep, fused.pieces, model));
    out.on_demand = std::make_shared<const ComplexOnDemand>(std::move(fused.cells));
  });
  return out;
}

CellularModel restore_cells(const FeatureModel& model, const Membership& membership,
                            BoundaryParts parts) {
  CellularModel out = join_boundary(std::move(parts), model, membership);
  out.on_demand = std::make_shared<const ComplexOnDemand>(model);
  return out;
}

CellularModel restore_cells(const FeatureModel& model, BoundaryParts parts) {
  return restore_cells(model, Membership(model), std::move(parts));
}

}  // namespace remeshd
