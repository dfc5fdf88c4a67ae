#pragma once

#include <functional>
#include <vector>

namespace remeshd {

/// Runs all jobs, started in their order, on this thread and up to three others. They must not
/// touch the same data. Returns once all are done; of what they threw, throws that of the first in
/// their order.
void do_side_by_side(const std::vector<std::function<void()>>& jobs);

}  // namespace remeshd
