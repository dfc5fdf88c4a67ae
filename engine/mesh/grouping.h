#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace remeshd {

/// Sorts the values and removes duplicates.
template <class Values>
void sort_unique(Values& values) {
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Items by group, 0 .. n - 1, in one array.
template <class Item>
struct Grouping {
  std::vector<std::uint32_t> begin;  ///< by group, its first item; then the number of items
  std::vector<Item> items;           ///< group by group, each in the order in which they came

  [[nodiscard]] std::span<const Item> operator[](std::size_t group) const {
    return {items.data() + begin[group], begin[group + 1] - begin[group]};
  }
};

/// Groups items by counting sort. `each(visit)` calls visit(group, item) for all of them; it is
/// called twice and has to do the same both times.
template <class Item, class Each>
Grouping<Item> grouped(std::size_t groups, const Each& each) {
  Grouping<Item> out;
  out.begin.assign(groups + 1, 0);
  each([&](std::size_t group, const Item&) { ++out.begin[group + 1]; });
  std::partial_sum(out.begin.begin(), out.begin.end(), out.begin.begin());
  out.items.resize(out.begin.back());
  std::vector<std::uint32_t> next(out.begin.begin(), out.begin.end() - 1);
  each([&](std::size_t group, const Item& item) { out.items[next[group]++] = item; });
  return out;
}

}  // namespace remeshd
