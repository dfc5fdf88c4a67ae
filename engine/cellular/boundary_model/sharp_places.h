#pragma once

#include <cstdint>
#include <vector>

#include "engine/cellular/boundary_model/support.h"
#include "engine/model/solid.h"

namespace remeshd {

/// Where the model itself is sharper than a good mesh's dihedral angles: no mesh does better there.
struct SharpPlaces {
  std::vector<std::uint8_t> edges;  ///< by edge: material ends in a wedge somewhere along it
  /// By vertex: a sharp edge ends there, or two edges of one face meet at a sharp angle; in a
  /// tangency that is nought.
  std::vector<std::uint8_t> vertices;

  [[nodiscard]] bool any() const;
  [[nodiscard]] bool holds(const Support& support) const;
};

/// The edges and vertices with an angle below `angle` (rad).
SharpPlaces sharp_places(const BoundaryModel& boundary, const Membership& membership, double angle);

}  // namespace remeshd
