#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "engine/base/vec.h"

namespace remeshd::kernel {

/// Calls f(a, b), a < b, once for every two boxes that touch, in no order to rely on.
/// Source: CGAL, box_self_intersection_d (Zomorodian & Edelsbrunner 2000).
void for_each_touching_pair(std::span<const Box> boxes,
                            const std::function<void(std::int32_t, std::int32_t)>& f);

}  // namespace remeshd::kernel
