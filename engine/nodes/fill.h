#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "engine/base/run.h"
#include "engine/base/vec.h"

namespace remeshd {

struct FillOptions {
  double edge_length = 0;              ///< target edge length; grid cells are half as long
  double density = 0;                  ///< nodes per volume
  std::optional<std::uint32_t> count;  ///< instead of the density: this many nodes in all
  std::uint64_t seed = 1;
};

/// Spreads random nodes evenly over the part of the boxes where `inside` holds: a grid is traversed
/// in serpentine order, every grid cell with its centre inside receives its share, and what is not
/// whole is carried on to the next.
///
/// Source: Sect. 3.2 and 7 (Alliez et al. 2005).
std::vector<Vec3> fill(const std::vector<Box>& boxes,
                       const std::function<bool(const Vec3&)>& inside, const FillOptions& options,
                       const Run& run);

}  // namespace remeshd
