#include "engine/revision/storage/stored_revision_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "engine/model/limits.h"
#include "engine/revision/delaunay_state.h"

namespace remeshd {
namespace {

[[noreturn]] void fail(const char* array) {
  throw error::internal("store", std::string("wrong values in the stored array ") + array);
}

void expect_size(std::size_t size, std::size_t expected, const char* array) {
  if (size != expected) fail(array);
}

/// Each value is in [least, end).
template <class Values>
void expect_below(const Values& values, std::int64_t least, std::size_t end, const char* array) {
  for (const auto value : values)
    if (value < least || value >= static_cast<std::int64_t>(end)) fail(array);
}

bool is_finite(const Vec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

void expect_finite(bool finite, const char* array) {
  if (!finite) fail(array);
}

/// Nodes lie in features, whose coordinates and sizes are at most kMaxLength.
bool is_place(const Vec3& p) {
  constexpr double kMost = 100 * kMaxLength;
  return std::fabs(p.x) <= kMost && std::fabs(p.y) <= kMost && std::fabs(p.z) <= kMost;
}

void check_places(const CowVector<Vec3>& places, const char* array) {
  places.for_each([&](std::size_t, const Vec3& p) {
    if (!is_place(p)) fail(array);
  });
}

void check_supports(const CowVector<Support>& supports, const BoundaryModel& boundary,
                    const char* array) {
  supports.for_each([&](std::size_t, const Support& s) {
    std::size_t entities = 0;
    switch (s.kind) {
      case Support::Kind::Interior:
        return;
      case Support::Kind::Face:
        entities = boundary.faces.size();
        break;
      case Support::Kind::Edge:
        entities = boundary.edges.size();
        break;
      case Support::Kind::Vertex:
        entities = boundary.vertices.size();
        break;
      default:
        fail(array);
    }
    if (s.entity < 0 || s.entity >= static_cast<std::int64_t>(entities)) fail(array);
  });
}

void check_delivery(const OutputMesh& d) {
  const std::size_t nodes = d.mesh.nodes.size(), tets = d.mesh.tets.size();
  check_places(d.mesh.nodes, "delivery.nodes");
  d.mesh.tets.for_each(
      [&](std::size_t, const Tet& tet) { expect_below(tet, 0, nodes, "delivery.tets"); });
  expect_size(d.node_ids.size(), nodes, "delivery.node_ids");
  expect_size(d.tet_ids.size(), tets, "delivery.tet_ids");
  for (const std::vector<std::string>& faces : d.groups.facet_groups)
    if (faces.empty()) fail("delivery.facet_groups");
  for (const MeshFacet& facet : d.groups.facets) {
    expect_below(facet.nodes, 0, nodes, "delivery.facets");
    expect_below(std::array{facet.tet}, 0, tets, "delivery.facet_tets");
    expect_below(std::array{facet.group}, 0, d.groups.facet_groups.size(), "delivery.facet_group");
  }
  expect_size(d.groups.tet_cell.size(), tets, "delivery.tet_cells");
  expect_below(d.groups.tet_cell, 0, d.groups.cell_owners.size(), "delivery.tet_cells");
  const NodeMap& map = d.map;
  expect_size(map.node_origin.size(), nodes, "delivery.node_origins");
  map.node_origin.for_each([&](std::size_t, NodeOrigin origin) {
    if (origin > NodeOrigin::Moved) fail("delivery.node_origins");
  });
  constexpr std::size_t kAny = std::size_t{1} << 31U;  // of the parent, which is not here
  expect_size(map.original_node.size(), nodes, "delivery.original_nodes");
  expect_below(map.original_node, -1, kAny, "delivery.original_nodes");
  expect_size(map.node_transform.size(), nodes, "delivery.node_transforms");
  expect_below(map.node_transform, -1, map.transforms.size(), "delivery.node_transforms");
  expect_size(map.original_tet.size(), tets, "delivery.original_tets");
  expect_below(map.original_tet, -1, kAny, "delivery.original_tets");
  expect_size(map.transform_features.size(), map.transforms.size(), "delivery.transforms");
}

void check_master(const DelaunayState& m, const OutputMesh& d, const BoundaryModel& boundary) {
  if (!m.mesh.consistent()) fail("delaunay.slots");
  check_places(m.positions(), "delaunay.points");
  for (const Vec3& corner : m.mesh.super_vertices())
    expect_finite(is_finite(corner), "delaunay.points");
  expect_size(m.positions().size(), d.mesh.nodes.size(), "delaunay.points");
  expect_size(m.supports.size(), d.mesh.nodes.size(), "master.supports");
  check_supports(m.supports, boundary, "master.supports");
  expect_size(m.tet_of_slot.size(), m.mesh.slots(), "master.tet_of_slot");
  expect_below(m.tet_of_slot, -1 - static_cast<std::int64_t>(m.cavities.size()), d.mesh.tets.size(),
               "master.tet_of_slot");
  for (std::int32_t slot = 0; slot < static_cast<std::int32_t>(m.mesh.slots()); ++slot)
    if (m.inside(slot))
      expect_below(m.mesh.corners(slot), 0, d.mesh.nodes.size(), "delaunay.slots");
  m.cavities.for_each([&](std::size_t, const Cavity& c) {
    expect_below(c.delaunay, 0, m.mesh.slots(), "master.clusters");
    expect_below(c.output, 0, d.mesh.tets.size(), "master.clusters");
  });
}

void check_names(const std::vector<FaceName>& names, const FeatureModel& model) {
  for (const FaceName& name : names)
    expect_below(std::array{name.feature}, 0, model.features.size(), "names of faces");
}

void check_face(const kernel::BrepFace& face, const kernel::Brep& brep) {
  expect_below(face.edges, 0, brep.edges.size(), "edges of faces");
  for (const auto& triangle : face.triangles)
    expect_below(triangle, 0, brep.points.size(), "triangles of faces");
  expect_finite(
      is_finite(face.centroid) && std::isfinite(face.area) && std::isfinite(face.swept_volume),
      "faces");
}

void check_edge(const kernel::BrepEdge& edge, const kernel::Brep& brep) {
  if (edge.kind < kernel::BrepEdge::Kind::Line || edge.kind > kernel::BrepEdge::Kind::Other)
    fail("kinds of edges");
  expect_below(edge.vertices, 0, brep.vertices.size(), "vertices of edges");
  expect_below(edge.chain, 0, brep.points.size(), "points of edges");
  if (edge.points.size() < 2 || edge.chain.size() < 2) fail("points of edges");
  for (const Vec3& p : edge.points) expect_finite(is_finite(p), "points of edges");
  for (const Vec3& p : edge.tangents) expect_finite(is_finite(p), "tangents of edges");
  for (const auto& [p, along] : edge.samples)
    expect_finite(is_finite(p) && is_finite(along), "samples of edges");
  expect_finite(is_finite(edge.centre) && is_finite(edge.axis) && std::isfinite(edge.radius) &&
                    std::isfinite(edge.length),
                "circles of edges");
}

void check_piece(const BoundaryPiece& piece, const FeatureModel& model) {
  const Surface& surface = piece.surface;
  if (surface.kind < Surface::Kind::Plane || surface.kind > Surface::Kind::Torus)
    fail("kinds of surfaces");
  for (const double number : surface.frame.m) expect_finite(std::isfinite(number), "surfaces");
  expect_finite(std::isfinite(surface.r1) && std::isfinite(surface.r2), "surfaces");
  if (piece.material_names.empty() && piece.other_names.empty()) fail("names of faces");
  check_names(piece.material_names, model);
  check_names(piece.other_names, model);
}

void check_mids(const OutputMesh& d) {
  const MidNodes& m = d.mids;
  const std::size_t mids = m.positions.size();
  check_places(m.positions, "mids.nodes");
  expect_size(m.edges.size(), mids, "mids.edges");
  m.edges.for_each([&](std::size_t, const auto& corners) {
    expect_below(corners, 0, d.mesh.nodes.size(), "mids.edges");
  });
  expect_size(m.of_tets.size(), mids > 0 ? d.mesh.tets.size() : 0, "mids.tets");
  m.of_tets.for_each(
      [&](std::size_t, const auto& of_tet) { expect_below(of_tet, 0, mids, "mids.tets"); });
  expect_size(m.ids.size(), mids, "mids.ids");
  expect_size(m.origin.size(), mids, "mids.origins");
  m.origin.for_each([&](std::size_t, NodeOrigin origin) {
    if (origin > NodeOrigin::Moved) fail("mids.origins");
  });
  constexpr std::size_t kAny = std::size_t{1} << 31U;  // of the parent, which is not here
  expect_size(m.original.size(), mids, "mids.originals");
  expect_below(m.original, -1, kAny, "mids.originals");
  expect_size(m.transform.size(), mids, "mids.transforms");
  expect_below(m.transform, -1, d.map.transforms.size(), "mids.transforms");
  expect_below(m.straightened, 0, mids, "mids.straightened");
  if (!std::ranges::is_sorted(m.straightened)) fail("mids.straightened");
}

/// The sizes of nodes, where there are any, and the dense places.
void check_sizes(const Revision& revision) {
  constexpr const char* kArray = "sizes.nodes";
  for (const SizedBall& ball : revision.dense_places)
    expect_finite(is_place(ball.centre) && std::isfinite(ball.radius) && ball.radius >= 0 &&
                      std::isfinite(ball.size) && ball.size > 0,
                  "dense places");
  if (revision.output.node_sizes.empty()) return;
  expect_size(revision.output.node_sizes.size(), revision.output.mesh.nodes.size(), kArray);
  revision.output.node_sizes.for_each([&](std::size_t, double size) {
    if (!std::isfinite(size) || size <= 0) fail(kArray);
  });
}

}  // namespace

void check_parts(const BoundaryParts& parts, const FeatureModel& model) {
  const kernel::Brep& brep = parts.brep;
  expect_size(parts.pieces.size(), brep.faces.size(), "faces");
  if (brep.vertices.size() > brep.points.size()) fail("points");
  std::vector<char> bounds(brep.edges.size(), 0);
  for (const kernel::BrepFace& face : brep.faces) {
    check_face(face, brep);
    for (const int edge : face.edges) bounds[static_cast<std::size_t>(edge)] = 1;
  }
  if (std::ranges::find(bounds, 0) != bounds.end()) fail("edges of faces");
  for (const kernel::BrepEdge& edge : brep.edges) check_edge(edge, brep);
  for (const kernel::BrepVertex& vertex : brep.vertices)
    expect_finite(is_finite(vertex.position), "vertices");
  for (const Vec3& p : brep.points) expect_finite(is_finite(p), "points");
  for (const BoundaryPiece& piece : parts.pieces) check_piece(piece, model);
  expect_finite(is_finite(brep.reference) && std::isfinite(brep.scale) && brep.scale > 0,
                "reference point");
}

void check_indices(const Revision& revision) {
  expect_finite(std::isfinite(revision.edge_length) && revision.edge_length > 0, "edge length");
  for (const Transform& transform : revision.output.map.transforms)
    for (const double number : transform.m)
      expect_finite(std::isfinite(number), "delivery.transforms");
  check_delivery(revision.output);
  check_sizes(revision);
  check_mids(revision.output);
  check_master(*revision.delaunay_state, revision.output, revision.cells.boundary);
  if (const Anchor* anchor = revision.anchor.get()) {
    check_places(anchor->nodes, "anchor.nodes");
    expect_size(anchor->nodes.size(), revision.output.mesh.nodes.size(), "anchor.nodes");
    expect_size(anchor->supports.size(), anchor->nodes.size(), "anchor.supports");
    check_supports(anchor->supports, revision.cells.boundary, "anchor.supports");
  }
}

}  // namespace remeshd
