#include "tests/bench/statistics.h"

#include <algorithm>
#include <cstddef>

namespace remeshd::bench {

std::optional<double> median(std::vector<double> values) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

std::vector<double> present(const Rounds& rounds) {
  std::vector<double> values;
  for (const std::optional<double>& value : rounds)
    if (value) values.push_back(*value);
  return values;
}

std::optional<double> pairwise_ratio(const Rounds& a, const Rounds& b) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    if (a[i] && b[i] && *b[i] > 0) ratios.push_back(*a[i] / *b[i]);
  return median(std::move(ratios));
}

}  // namespace remeshd::bench
