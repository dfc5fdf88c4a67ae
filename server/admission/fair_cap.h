#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace remeshd {

/// The greatest cap for which `amounts`, each cut down to the cap, sum up to at most `total`.
/// Amounts below the cap are kept, so those who have most give way first. The greatest
/// std::uint64_t where all amounts fit.
std::uint64_t fair_cap(std::vector<std::uint64_t> amounts, std::uint64_t total);

/// One of several holders that share a budget. The budget calls the functions under its mutex.
struct BudgetHolder {
  std::function<std::uint64_t()> bytes;  ///< that the holder has
  /// Makes the holder give way until it has at most `most` bytes, as far as it can.
  std::function<void(std::uint64_t most)> shrink;
  bool gives_way = true;  ///< false: what it has stays until somebody deletes it
};

}  // namespace remeshd
