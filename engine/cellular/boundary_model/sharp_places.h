#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/cellular/boundary_model/support.h"
#include "engine/model/solid.h"

namespace remeshd {

/// Where the model itself is sharper than a good mesh's dihedral angles: no mesh does better there.
struct SharpPlaces {
  std::vector<std::uint8_t> edges;  ///< by edge: material ends in a wedge somewhere along it
  /// By vertex: a sharp edge ends there, or two edges of one face meet at a sharp angle, which is 0
  /// where they are tangent.
  std::vector<std::uint8_t> vertices;

  [[nodiscard]] bool any() const;
  [[nodiscard]] bool holds(const Support& support) const;
};

/// Walls thinner than a length: a tet across one is flat in any mesh.
class ThinWalls {
 public:
  /// Keeps a reference to `boundary`.
  ThinWalls(const BoundaryModel& boundary, double thinner_than);

  /// Whether the tet of these nodes lies across a thin wall: a boundary node is nearer than
  /// `thinner_than` to the surface of a face that another node stands on, and that face is none of
  /// the node's own and shares no edge with them.
  [[nodiscard]] bool holds(const std::array<Support, 4>& supports,
                           const std::array<Vec3, 4>& nodes) const;

 private:
  [[nodiscard]] std::vector<int> faces_of(const Support& support) const;
  [[nodiscard]] bool meet(std::span<const int> faces, int face) const;

  const BoundaryModel& boundary_;
  double thinner_than_;
  std::vector<std::vector<int>>
      neighbours_;  ///< by face: those that it shares an edge with, itself
};

/// The edges and vertices with an angle below `angle` (rad).
SharpPlaces sharp_places(const BoundaryModel& boundary, const Membership& membership, double angle);

}  // namespace remeshd
