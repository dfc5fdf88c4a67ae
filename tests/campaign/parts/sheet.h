#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace remeshd::campaign {

/// What a detail covers of the sheet it stands on: all within `radius` of a segment.
struct Footprint {
  std::array<double, 2> from{}, to{};
  double radius = 0;
  double detail = 0;  ///< the least size of what stands there, which gaps go by
};

/// A flat side of a part's body, local z out of the material, where details stand apart.
struct Sheet {
  Transform frame;
  double half_x = 0, half_y = 0;  ///< of a rectangle
  double radius = 0, inner = 0;   ///< of a disc or ring, where `radius` is positive
  double depth = 0;               ///< of the material below
  bool through = false;           ///< holes may go all through
  std::vector<Footprint> taken;

  [[nodiscard]] double width() const {
    return radius > 0 ? 2 * (radius - inner) : 2 * std::min(half_x, half_y);
  }
  /// Whether all of them have room, apart from what stands there and from the rim.
  [[nodiscard]] bool has_room(std::span<const Footprint> wanted) const;
};

/// How far two footprints are apart; negative where they overlap.
double gap(const Footprint& a, const Footprint& b);

}  // namespace remeshd::campaign
