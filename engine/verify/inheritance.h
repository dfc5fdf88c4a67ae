#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/run.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

/// A facet that is in one tet only.
struct SurfaceFacet {
  Triangle nodes;  ///< outward
  std::int32_t tet;
  friend bool operator==(const SurfaceFacet&, const SurfaceFacet&) = default;
};

/// A mesh that was found valid, and what another mesh claims to have of it.
struct VerifiedParent {
  PagedMesh mesh;
  std::vector<SurfaceFacet> surface;
  double volume = 0;
  Pages<std::int32_t> node;  ///< by node of the other: the parent's node, or -1
  Pages<std::int32_t> tet;   ///< by tet of the other: the parent's tet, or -1
};

/// Which claims on a parent hold; a false one costs the inheritance and nothing else.
///
/// Two tets are the same if the parent's nodes, each taken by one node at most, make them so, in
/// the same turn. Such tets meet across facets as they did in the parent. Where no node has moved
/// they are positive as well.
struct Inheritance {
  std::vector<std::int32_t> heir;  ///< by tet of the parent: the tet that is the same, or -1
  std::vector<std::int32_t> name;  ///< by node of the parent: the node that took it, or -1
  /// By node: 1 in tets that are not the parent's, or in the parent in tets that are gone. The
  /// facets, boundary edges and fans of all others are as they were.
  std::vector<std::uint8_t> touched;
  /// Tets that are not the parent's in every respect, ascending, and the parent's that have no heir
  /// that is.
  std::vector<std::int32_t> changed, gone;
  std::vector<std::int32_t> near;  ///< tets with a touched node, ascending
};

Inheritance inherit(const PagedMesh& mesh, const VerifiedParent& parent, Polling& poll);

}  // namespace remeshd
