#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/cow_vector.h"
#include "engine/cellular/boundary_model/support.h"
#include "engine/delaunay/paged_delaunay.h"

namespace remeshd {

/// Delaunay tets and the output tets that clean-up put in their place, with the same hull.
struct Cavity {
  friend bool operator==(const Cavity&, const Cavity&) = default;
  std::vector<std::int32_t> delaunay;
  std::vector<std::int32_t> output;
};

/// The Delaunay mesh that a revision's output mesh was cleaned up from, and that the next edit
/// copies its nodes from, moved as they have been since (copied_mesh.h). Node i of the Delaunay
/// mesh is node i of the output mesh.
struct DelaunayState {
  static constexpr std::int32_t kOutside = -1;

  PagedDelaunay mesh;           ///< of all nodes, the outside included
  CowVector<Support> supports;  ///< entities of the revision's BoundaryModel
  /// By slot of `mesh`: the output tet that is the same, kOutside where the tet is not in the
  /// model, -2 - c where it is in cavity c.
  CowVector<std::int32_t> tet_of_slot;
  /// Each by slots of `mesh` and output tets; an empty one is a free number, to be used again.
  CowVector<Cavity> cavities;
  std::uint64_t next_node_id = 1;  ///< permanent ids below are taken along the chain of ancestors
  std::uint64_t next_tet_id = 1;

  [[nodiscard]] const CowVector<Vec3>& positions() const { return mesh.positions(); }
  [[nodiscard]] bool inside(std::int32_t slot) const {
    return tet_of_slot[slot] != kOutside && mesh.in_use(slot);
  }
  [[nodiscard]] std::int32_t cavity_of(std::int32_t slot) const {
    return tet_of_slot[slot] < kOutside ? -2 - tet_of_slot[slot] : -1;
  }
};

}  // namespace remeshd
