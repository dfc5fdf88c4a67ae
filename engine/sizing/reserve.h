#pragma once

namespace remeshd {

/// What rules and the model ask for is asked for so many times finer. Where lengths grow from a
/// face on, a mesh's edges come out unevenly long, and longer than the field by about that.
inline constexpr double kReserve = 1.2;

}  // namespace remeshd
