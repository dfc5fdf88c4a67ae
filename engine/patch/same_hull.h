#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/run.h"
#include "engine/mesh/grouping.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

/// The tets of two meshes of the same body, by numbers of nodes; facets with a negative number are
/// not looked at.
struct TwoMeshes {
  std::span<const Tet> first, second;            ///< that only one of them has
  std::span<const Tet> first_stay, second_stay;  ///< the same, but they may not be exchanged
  std::span<const Tet> both;                     ///< that both have
};

/// Which tets of two meshes may be exchanged for each other: the largest set in which those of the
/// one mesh have the same hull as those of the other, but for facets on the surface of the body.
///
/// Each tet needs others, facet by facet. Where the other mesh has a tet on the same side of the
/// facet, it needs that one. Where the other mesh has no such facet, it needs its own neighbour
/// across it; on the surface it needs none. Otherwise it cannot be exchanged, and no tet can that
/// needs it. A tet whose facets all lie on the surface, as one that peeling leaves, needs none.
class SameHull {
 public:
  /// `node_count`: more than every node number of the tets. Throws Cancelled.
  SameHull(const TwoMeshes& meshes, std::size_t node_count, const Run& run);

  /// Whether a tet may be exchanged, together with all others of which that is so.
  [[nodiscard]] bool first(std::size_t k) const { return in_[k] != 0; }
  [[nodiscard]] bool second(std::size_t k) const { return in_[first_count_ + k] != 0; }

 private:
  void leave_out(std::int32_t tet);

  std::size_t first_count_;
  std::vector<std::uint8_t> in_;      ///< by tet of the first mesh, then by tet of the second
  Grouping<std::int32_t> needed_by_;  ///< by tet: those that need it
};

}  // namespace remeshd
