#include "engine/kernel/box_pairs.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <vector>

namespace remeshd::kernel {

void for_each_touching_pair(std::span<const Box> boxes,
                            const std::function<void(std::int32_t, std::int32_t)>& f) {
  using Handled = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const Box*>;
  std::vector<Handled> handled;
  handled.reserve(boxes.size());
  for (const Box& b : boxes)
    handled.emplace_back(CGAL::Bbox_3(b.lo.x, b.lo.y, b.lo.z, b.hi.x, b.hi.y, b.hi.z), &b);
  CGAL::box_self_intersection_d(
      handled.begin(), handled.end(), [&](const Handled& a, const Handled& b) {
        const auto i = static_cast<std::int32_t>(a.handle() - boxes.data());
        const auto j = static_cast<std::int32_t>(b.handle() - boxes.data());
        f(std::min(i, j), std::max(i, j));
      });
}

}  // namespace remeshd::kernel
