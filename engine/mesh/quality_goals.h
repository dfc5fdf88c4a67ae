#pragma once

#include <numbers>

namespace remeshd::goals {

/// Quality that a morph must keep wherever the mesh had it. Angles in rad, measures by
/// volume-length.
inline constexpr double kLeastDihedral = 25 * std::numbers::pi / 180;
inline constexpr double kLargestDihedral = 145 * std::numbers::pi / 180;
inline constexpr double kLeastMeasure = 0.42;
/// Tets below are cleaned up unless the options say otherwise: at 15,000 nodes .45 leaves dihedral
/// angles from 20 degrees in 10 ms, .52 from 25 in 20, .6 from 27 in 45.
inline constexpr double kThreshold = 0.52;

}  // namespace remeshd::goals
