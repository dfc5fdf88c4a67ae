#pragma once

#include <cstdint>

#include "engine/base/pages.h"
#include "engine/cellular/support.h"
#include "engine/kernel/paged_delaunay.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/remesh/pieces.h"

namespace remeshd {

/// The Delaunay mesh that a revision's delivered mesh was cleaned up from, and that the next edit
/// copies its nodes from. Node i of the master is node i of the delivered mesh.
struct Master {
  static constexpr std::int32_t kOutside = -1;

  kernel::PagedDelaunay mesh;  ///< of all nodes, the outside included
  Pages<Support> supports;     ///< entities of the revision's BoundaryModel
  /// By slot of `mesh`: the delivered tet that is the same, kOutside where the tet is not in the
  /// model, -2 - c where it is in cluster c.
  Pages<std::int32_t> tet_of_slot;
  /// Of slots and delivered tets; those without any are free to be used again.
  Pages<Cluster> clusters;
  std::uint64_t next_node_id = 1;  ///< permanent ids below are taken along the chain of ancestors
  std::uint64_t next_tet_id = 1;

  [[nodiscard]] const Pages<Vec3>& positions() const { return mesh.positions(); }
  [[nodiscard]] bool inside(std::int32_t slot) const {
    return tet_of_slot[slot] != kOutside && mesh.in_use(slot);
  }
  [[nodiscard]] std::int32_t cluster_of(std::int32_t slot) const {
    return tet_of_slot[slot] < kOutside ? -2 - tet_of_slot[slot] : -1;
  }
};

}  // namespace remeshd
