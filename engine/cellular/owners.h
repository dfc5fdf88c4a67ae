#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

namespace remeshd {

/// Adds owners to others, both ascending.
inline void merge_owners(std::vector<int>& owners, const std::vector<int>& more) {
  std::vector<int> merged;
  std::set_union(owners.begin(), owners.end(), more.begin(), more.end(),
                 std::back_inserter(merged));
  owners = std::move(merged);
}

}  // namespace remeshd
