#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

namespace remeshd {

/// Adds `more` to `owners`, each once. Pre: both ascend.
inline void merge_owners(std::vector<int>& owners, const std::vector<int>& more) {
  std::vector<int> merged;
  std::set_union(owners.begin(), owners.end(), more.begin(), more.end(),
                 std::back_inserter(merged));
  owners = std::move(merged);
}

}  // namespace remeshd
