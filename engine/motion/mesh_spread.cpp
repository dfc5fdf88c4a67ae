#include "engine/motion/mesh_spread.h"

#include <array>
#include <cmath>

#include "engine/boundary/edge_chains.h"

namespace remeshd {
namespace {

std::vector<std::int32_t> nodes_on(const CowVector<Support>& supports, Support::Kind kind) {
  std::vector<std::int32_t> nodes;
  for (std::size_t n = 0; n < supports.size(); ++n)
    if (supports[n].kind == kind) nodes.push_back(static_cast<std::int32_t>(n));
  return nodes;
}

/// Along the model's edges. Weight of a link: one over its length.
Spread along_edges(const Revision& revision, const CowVector<Vec3>& nodes) {
  std::vector<MotionLink> links;
  const std::vector<Support> supports = revision.supports().flat();
  for (const auto& chain : edge_chains(revision.cells.boundary, supports, nodes))
    for (std::size_t k = 1; k < chain.size(); ++k) {
      const std::int32_t a = chain[k - 1].node, b = chain[k].node;
      const double length = distance(nodes[a], nodes[b]);
      if (a != b && length > 0) links.push_back({a, b, 1 / length});
    }
  return {nodes_on(revision.supports(), Support::Kind::Edge), links, nodes.size()};
}

/// Over the boundary. Weights: those of linear triangles, cotangents.
Spread over_faces(const Revision& revision, const CowVector<Vec3>& nodes, Polling& poll) {
  std::vector<MotionLink> links;
  for (const MeshFacet& facet : revision.output.groups.facets) {
    poll();
    const Vec3 &a = nodes[facet.nodes[0]], &b = nodes[facet.nodes[1]], &c = nodes[facet.nodes[2]];
    const double twice_area = norm(cross(b - a, c - a));
    if (!(twice_area > 0)) continue;
    // Half the cotangent of the angle across from each side.
    links.push_back({facet.nodes[0], facet.nodes[1], dot(a - c, b - c) / (2 * twice_area)});
    links.push_back({facet.nodes[1], facet.nodes[2], dot(b - a, c - a) / (2 * twice_area)});
    links.push_back({facet.nodes[2], facet.nodes[0], dot(c - b, a - b) / (2 * twice_area)});
  }
  return {nodes_on(revision.supports(), Support::Kind::Face), links, nodes.size()};
}

/// Through the material. Weights: those of linear tets.
Spread through_tets(const Revision& revision, const CowVector<Vec3>& nodes, Polling& poll) {
  std::vector<MotionLink> links;
  links.reserve(6 * revision.output.mesh.tets.size());
  for (const Tet& tet : revision.output.mesh.tets) {
    poll();
    std::array<Vec3, 4> p;
    for (int k = 0; k < 4; ++k) p[k] = nodes[tet[k]];
    const double six_volumes = dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]);
    if (!(six_volumes > 0)) continue;
    std::array<Vec3, 4> area;  // twice each facet's, along its normal
    for (int k = 0; k < 4; ++k) {
      const auto [a, b, c] = kTetFacets[k];
      area[k] = cross(p[b] - p[a], p[c] - p[a]);
    }
    for (const auto& [a, b] : kTetEdges)
      links.push_back({tet[a], tet[b], -dot(area[a], area[b]) / (6 * six_volumes)});
  }
  return {nodes_on(revision.supports(), Support::Kind::Interior), links, nodes.size()};
}

}  // namespace

MeshSpread::MeshSpread(const Revision& revision, const CowVector<Vec3>& nodes, const Run& run)
    : edges_(along_edges(revision, nodes)),
      faces_([&] {
        Polling poll(run);
        return over_faces(revision, nodes, poll);
      }()),
      interior_([&] {
        Polling poll(run);
        return through_tets(revision, nodes, poll);
      }()) {}

std::vector<Vec3> MeshSpread::forward(std::span<const NodeMotion> motions, const Run& run) const {
  std::vector<Vec3> u(motions.size());
  for (std::size_t n = 0; n < motions.size(); ++n) u[n] = motions[n].required;
  for (const Spread* stage : {&edges_, &faces_, &interior_}) stage->forward(motions, u, run);
  return u;
}

std::vector<Vec3> MeshSpread::reverse(std::span<const NodeMotion> motions, std::vector<Vec3> seed,
                                      const Run& run) const {
  for (const Spread* stage : {&interior_, &faces_, &edges_}) stage->reverse(motions, seed, run);
  for (const std::int32_t n : interior_.nodes()) seed[n] = {};
  return seed;
}

}  // namespace remeshd
