#pragma once

#include <functional>
#include <vector>

namespace remeshd {

/// Does all jobs, in their order, each as soon as one of the machine's processors is free for it,
/// this thread's among them. They must not touch the same things. Returns once all are done; throws
/// what one of them threw, the first in their order.
void do_side_by_side(const std::vector<std::function<void()>>& jobs);

}  // namespace remeshd
