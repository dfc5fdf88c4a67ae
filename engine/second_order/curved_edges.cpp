#include "engine/second_order/curved_edges.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/base/tolerance.h"
#include "engine/boundary/edge_chains.h"
#include "engine/boundary/facet_faces.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

namespace {

/// Model edges by the mesh edges that represent them.
class MeshEdgesOfModel {
 public:
  MeshEdgesOfModel(const BoundaryModel& boundary, const std::vector<Support>& supports,
                   const CowVector<Vec3>& nodes) {
    const auto chains = edge_chains(boundary, supports, nodes);
    for (std::size_t e = 0; e < chains.size(); ++e)
      for (std::size_t k = 1; k < chains[e].size(); ++k) {
        const auto [a, b] = std::minmax(chains[e][k - 1].node, chains[e][k].node);
        known_.push_back({{a, b}, static_cast<int>(e)});
      }
    std::ranges::sort(known_, {}, &Known::corners);
  }
  /// -1: none, or two, as of a closed edge with two nodes.
  [[nodiscard]] int of(const std::array<std::int32_t, 2>& corners) const {
    const auto found = std::ranges::equal_range(known_, corners, {}, &Known::corners);
    return found.size() == 1 ? found.front().edge : -1;
  }

 private:
  struct Known {
    std::array<std::int32_t, 2> corners;
    int edge;
  };
  std::vector<Known> known_;
};

/// The model faces of the two facets at each mesh edge of the boundary; -1 for none.
std::vector<std::array<int, 2>> faces_beside(const OutputMesh& output,
                                             const BoundaryModel& boundary,
                                             const std::vector<Support>& supports,
                                             const MidNumbers& numbers, Polling& poll) {
  const FacetFaces faces(boundary, supports);
  std::vector<std::array<int, 2>> beside(numbers.edges.size(), {-1, -1});
  const CowVector<Vec3>& p = output.mesh.nodes;
  for (const MeshFacet& facet : output.groups.facets) {
    poll();
    const int face =
        faces.face_of(facet.nodes, p[facet.nodes[0]], p[facet.nodes[1]], p[facet.nodes[2]]);
    if (face < 0) continue;
    const Tet& tet = output.mesh.tets[facet.tet];
    for (int k = 0; k < 6; ++k) {
      if (!has_corner(facet.nodes, tet[kTetEdges[k][0]]) ||
          !has_corner(facet.nodes, tet[kTetEdges[k][1]]))
        continue;
      std::array<int, 2>& both = beside[numbers.of_tets[facet.tet][k]];
      (both[0] < 0 ? both[0] : both[1]) = face;
    }
  }
  return beside;
}

}  // namespace

std::vector<CurvedEdge> curved_edges(const Revision& revision, const MidNumbers& numbers,
                                     const Run& run) {
  Polling poll(run);
  const BoundaryModel& boundary = revision.cells.boundary;
  const OutputMesh& output = revision.output;
  const std::vector<Support> supports = revision.supports().flat();
  const MeshEdgesOfModel on_model_edge(boundary, supports, output.mesh.nodes);
  const auto beside = faces_beside(output, boundary, supports, numbers, poll);
  const auto is_flat = [&](int face) {
    return boundary.faces[face].surface.kind == Surface::Kind::Plane;
  };
  std::vector<CurvedEdge> curved;
  for (std::size_t mid = 0; mid < beside.size(); ++mid) {
    poll();
    const auto [one, other] = beside[mid];
    if (one < 0 || (is_flat(one) && one == other)) continue;
    const auto& corners = numbers.edges[mid];
    const Vec3 &a = output.mesh.nodes[corners[0]], &b = output.mesh.nodes[corners[1]];
    const Vec3 middle = 0.5 * (a + b);
    Vec3 place = middle;
    if (const int edge = on_model_edge.of(corners); edge >= 0) {
      place = project(boundary, boundary.edges[edge], middle);
    } else if (one == other) {
      place = project(boundary.faces[one].surface, middle);
    }
    if (distance(place, middle) > tolerance::kStraight * distance(a, b))
      curved.push_back({static_cast<std::int32_t>(mid), place});
  }
  return curved;
}

}  // namespace remeshd
