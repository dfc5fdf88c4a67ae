#pragma once

#include <array>
#include <vector>

namespace remeshd {

/// The gap for places of a B-rep, x the kernel's tolerance.
inline constexpr double kOrderGap = 10;

/// Numbers by rank, equal for values that are no further apart than `gap` or are linked by others
/// that are not: an order of these is an order of the values that noise below the gap leaves alone.
std::vector<int> tolerant_ranks(const std::vector<double>& values, double gap);

/// The same for each column of a table of keys.
template <std::size_t N>
std::vector<std::array<int, N>> tolerant_ranks(const std::vector<std::array<double, N>>& keys,
                                               double gap) {
  std::vector<std::array<int, N>> out(keys.size());
  std::vector<double> column(keys.size());
  for (std::size_t k = 0; k < N; ++k) {
    for (std::size_t i = 0; i < keys.size(); ++i) column[i] = keys[i][k];
    const std::vector<int> ranks = tolerant_ranks(column, gap);
    for (std::size_t i = 0; i < keys.size(); ++i) out[i][k] = ranks[i];
  }
  return out;
}

}  // namespace remeshd
