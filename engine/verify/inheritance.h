#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/base/run.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/mesh/unchanged.h"

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
  CowVector<Box> boxes;  ///< round the tets
  std::vector<SurfaceFacet> surface;
  double volume = 0;
  CowVector<std::int32_t> node;  ///< by node of the other: the parent's node, or -1
  CowVector<std::int32_t> tet;   ///< by tet of the other: the parent's tet, or -1
};

/// By tet of a parent: the tet that is the same, or -1.
class CorrespondingTets {
 public:
  /// What is unchanged is its own counterpart, all others have none. `tets`: of the mesh; `then`:
  /// of the parent.
  CorrespondingTets(const Unchanged& unchanged, std::size_t tets, std::size_t then);

  std::int32_t operator[](std::int32_t tet) const {
    const std::int32_t begin = begin_[static_cast<std::size_t>(tet) / CowVector<Tet>::kPage];
    return begin < 0 ? tet
                     : same_tet_[begin + tet % static_cast<std::int32_t>(CowVector<Tet>::kPage)];
  }
  /// Pre: not of an unchanged page.
  void set(std::int32_t tet, std::int32_t same_tet) {
    const std::int32_t begin = begin_[static_cast<std::size_t>(tet) / CowVector<Tet>::kPage];
    same_tet_[begin + tet % static_cast<std::int32_t>(CowVector<Tet>::kPage)] = same_tet;
  }
  /// Calls f(tet) for those without counterpart, ascending.
  template <class F>
  void for_each_without(F&& f) const {
    for (std::size_t k = 0; k < begin_.size(); ++k) {
      const std::size_t first = k * CowVector<Tet>::kPage;
      const std::size_t end = std::min(first + CowVector<Tet>::kPage, then_);
      for (std::size_t o = first; begin_[k] >= 0 && o < end; ++o)
        if (same_tet_[begin_[k] + o - first] < 0) f(static_cast<std::int32_t>(o));
    }
  }

 private:
  std::size_t then_;
  std::vector<std::int32_t>
      begin_;  ///< by page: where its counterparts begin; -1 for unchanged ones
  std::vector<std::int32_t> same_tet_;
};

/// Which claims on a parent hold; a false one costs the inheritance and nothing else. What has not
/// changed is its own counterpart, whatever is claimed.
///
/// Two tets are the same if the parent's nodes, each taken by one node at most, make them so, in
/// the same turn. Such tets meet across facets as they did in the parent. Where no node has moved
/// they are positive as well.
struct TetCorrespondence {
  Unchanged unchanged;  ///< of the parent
  CorrespondingTets same_tet;
  std::vector<std::int32_t> name;  ///< by node of the parent: the node that took it, or -1
  /// By node: 1 in tets that are not the parent's, or in the parent in tets that are gone. The
  /// facets, boundary edges and fans of all others are as they were.
  std::vector<std::uint8_t> touched;
  /// Tets that are not the parent's in every respect, ascending, and the parent's that have no
  /// counterpart that is.
  std::vector<std::int32_t> changed, gone;
  std::vector<std::int32_t> near;  ///< tets with a touched node, ascending
};

TetCorrespondence correspond(const PagedMesh& mesh, const VerifiedParent& parent, Polling& poll);

}  // namespace remeshd
