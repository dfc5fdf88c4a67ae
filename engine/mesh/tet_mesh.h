#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/cow_vector.h"
#include "engine/base/vec.h"

namespace remeshd {

using Tet = std::array<std::int32_t, 4>;
using Triangle = std::array<std::int32_t, 3>;

inline bool has_corner(const Triangle& t, std::int32_t node) {
  return t[0] == node || t[1] == node || t[2] == node;
}

/// Nodes and tets. Inv: 0-based, every tet of positive volume:
/// dot(cross(b - a, c - a), d - a) > 0.
struct TetMesh {
  std::vector<Vec3> nodes;
  std::vector<Tet> tets;
};

/// A TetMesh as a revision keeps it: in pages, which it shares with other revisions.
struct PagedMesh {
  CowVector<Vec3> nodes;
  CowVector<Tet> tets;
};
inline PagedMesh paged(const TetMesh& mesh) {
  return {CowVector(mesh.nodes), CowVector(mesh.tets)};
}

/// The tet with each node n replaced by names[n].
inline Tet renamed(Tet tet, std::span<const std::int32_t> names) {
  for (std::int32_t& n : tet) n = names[n];
  return tet;
}

template <class Nodes>
Vec3 centroid(const Nodes& nodes, const Tet& t) {
  return 0.25 * (nodes[t[0]] + nodes[t[1]] + nodes[t[2]] + nodes[t[3]]);
}

/// The facet of a positive tet opposite its corner i, ordered so that its normal
/// cross(b - a, c - a) points out of the tet.
constexpr std::array<std::array<int, 3>, 4> kTetFacets{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// Corners of the edges of a tet, in VTK's order of mid-nodes.
constexpr std::array<std::array<int, 2>, 6> kTetEdges{
    {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

}  // namespace remeshd
