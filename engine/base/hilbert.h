#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace remeshd {

/// Position of p along a Hilbert curve through the box, 16 bits an axis (Skilling 2004).
std::uint64_t hilbert_key(const Vec3& p, const Box& box);

/// The points, sorted along a Hilbert curve through their bounding box.
std::vector<Vec3> along_hilbert_curve(std::span<const Vec3> points);

/// The nodes in a biased randomised insertion order (Amenta, Choi & Rote 2003): rounds of growing
/// size, each sorted along a Hilbert curve through `box`. The round of a node is drawn from its
/// index alone, so the same nodes give the same order.
std::vector<std::int32_t> insertion_order(std::span<const Vec3> positions,
                                          std::span<const std::int32_t> nodes, const Box& box);

}  // namespace remeshd
