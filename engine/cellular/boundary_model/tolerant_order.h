#pragma once

#include <array>
#include <vector>

namespace remeshd {

/// The gap for ranks of coordinates in a B-rep, x kernel_tolerance.
inline constexpr double kOrderGap = 10;

/// For each value its rank, from 0. Values share a rank where, in sorted order, no step between
/// them exceeds `gap`, so that noise far below `gap` does not change an order by rank.
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

/// Puts `values` into the order of these old indices; returns for each old index the new one, -1
/// where it was left out.
template <typename T>
std::vector<int> rearrange(std::vector<T>& values, const std::vector<int>& order) {
  std::vector<int> renumber(values.size(), -1);
  std::vector<T> sorted;
  sorted.reserve(order.size());
  for (const int i : order) {
    renumber[i] = static_cast<int>(sorted.size());
    sorted.push_back(std::move(values[i]));
  }
  values = std::move(sorted);
  return renumber;
}

}  // namespace remeshd
