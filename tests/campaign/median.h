#pragma once

#include <algorithm>
#include <vector>

namespace remeshd::campaign {

/// The upper of the two in the middle of an even number of them; 0 of none.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// The greatest; 0 of none.
inline double most(const std::vector<double>& values) {
  return values.empty() ? 0 : std::ranges::max(values);
}

}  // namespace remeshd::campaign
