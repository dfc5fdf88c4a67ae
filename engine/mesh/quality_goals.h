#pragma once

#include <numbers>

namespace remeshd::goals {

/// Quality that a morph must keep wherever the mesh had it. Angles in rad, measures by
/// volume-length.
inline constexpr double kLeastDihedral = 25 * std::numbers::pi / 180;
inline constexpr double kLargestDihedral = 145 * std::numbers::pi / 180;
inline constexpr double kLeastMeasure = 0.42;
/// Tets with a volume-length measure below this are cleaned up, unless the options give another
/// threshold. For a mesh of 15,000 nodes a threshold of .45 leaves no dihedral angle below 20
/// degrees and takes 10 ms, .52 none below 25 degrees in 20 ms, .6 none below 27 degrees in 45 ms.
inline constexpr double kThreshold = 0.52;

}  // namespace remeshd::goals
