#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace remeshd {

/// What each of several may have so that together they have no more than `total`: the same for all,
/// and as much as fits. Whoever has less keeps what it has, so those that have most give way first.
/// The greatest number there is where all of it fits.
std::uint64_t fair_cap(std::vector<std::uint64_t> amounts, std::uint64_t total);

/// One of several that share a budget. The budget calls the functions under its mutex.
struct BudgetHolder {
  std::function<std::uint64_t()> bytes;  ///< that it has
  /// Has it give way until it has no more than `most`, as far as it can.
  std::function<void(std::uint64_t most)> shrink;
  bool gives_way = true;  ///< false: what it has stays until somebody deletes it
};

}  // namespace remeshd
