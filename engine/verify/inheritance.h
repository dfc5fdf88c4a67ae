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

/// A mesh that was found valid, and which of its nodes and tets another mesh claims to have.
struct VerifiedParent {
  PagedMesh mesh;
  CowVector<Box> boxes;  ///< round the tets, one for each page of them
  std::vector<SurfaceFacet> surface;
  double volume = 0;
  CowVector<std::int32_t> node;  ///< by node of the other: the parent's node, or -1
  CowVector<std::int32_t> tet;   ///< by tet of the other: the parent's tet, or -1
};

/// By tet of a parent: its counterpart, the tet of the mesh that is the same, or -1.
class CorrespondingTets {
 public:
  /// Unchanged tets are their own counterparts, all others have none. `tets`: number of tets of the
  /// mesh; `then`: of the parent.
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
  /// Calls f(tet) for the parent's tets without counterpart, ascending.
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
      begin_;  ///< by page of the parent: where it begins in `same_tet_`; -1: unchanged
  std::vector<std::int32_t> same_tet_;
};

/// Which nodes and tets of a mesh have the counterparts in a verified parent that it claims. Where
/// a claim is false, the mesh is checked itself instead of inheriting the parent's verdict; nothing
/// else follows. Unchanged nodes and tets are their own counterparts, whatever is claimed.
///
/// A node of the parent has one counterpart at most. A tet is the counterpart of a parent's tet
/// only if its nodes are the counterparts of that tet's, in the same orientation. Such tets meet
/// across facets as they did in the parent, and where none of their nodes has moved they are
/// positive, too.
struct TetCorrespondence {
  Unchanged unchanged;  ///< of the parent
  CorrespondingTets same_tet;
  std::vector<std::int32_t> heir;  ///< by node of the parent: its counterpart, or -1
  /// By node: 1 if it has a tet without counterpart, or had one in the parent. The facets, boundary
  /// edges and fans at all other nodes are as they were.
  std::vector<std::uint8_t> touched;
  /// `changed`: tets without counterpart or with a node that has moved, ascending; `gone`: the
  /// parent's tets without counterpart, or whose counterpart has such a node.
  std::vector<std::int32_t> changed, gone;
  std::vector<std::int32_t> near;  ///< tets with a touched node, ascending
};

TetCorrespondence correspond(const PagedMesh& mesh, const VerifiedParent& parent, Polling& poll);

}  // namespace remeshd
