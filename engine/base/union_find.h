#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace remeshd {

/// Disjoint sets of 0 .. n - 1; a set is named by its smallest member (Tarjan 1975, by path
/// halving).
class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }

  std::int32_t find(std::int32_t a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  void join(std::int32_t a, std::int32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::int32_t> parent_;
};

}  // namespace remeshd
