#pragma once

#include <cmath>
#include <numbers>

namespace remeshd {

inline constexpr double kTurn = 2 * std::numbers::pi;  ///< rad: a full turn

/// The same angle in [0, kTurn].
inline double wrapped(double angle) {
  const double a = std::fmod(angle, kTurn);
  return a < 0 ? a + kTurn : a;
}

}  // namespace remeshd
