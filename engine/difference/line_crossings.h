#pragma once

#include <vector>

#include "engine/base/surface.h"

namespace remeshd {

/// The points p + t * direction, t from `begin` to `end`.
struct Line {
  Vec3 p;
  Vec3 direction;  ///< unit
  double begin = 0, end = 0;
};

/// Appends every t between `begin` and `end` at which the line crosses the surface, to rounding,
/// with the other nappe of a cone and the other part of a spindle torus. A line that touches may
/// give both of two equal values or none.
void append_crossings(const Surface& surface, const Line& line, std::vector<double>& out);

/// Shortens the line to the part within the box; false where nothing is left.
bool clip(Line& line, const Box& box);

}  // namespace remeshd
