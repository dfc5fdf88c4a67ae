#include "engine/cellular/boundary_model/tolerant_order.h"

#include <algorithm>
#include <numeric>

namespace remeshd {

std::vector<int> tolerant_ranks(const std::vector<double>& values, double gap) {
  std::vector<int> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](int i) { return values[i]; });
  std::vector<int> ranks(values.size());
  int rank = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k > 0 && values[order[k]] - values[order[k - 1]] > gap) ++rank;
    ranks[order[k]] = rank;
  }
  return ranks;
}

}  // namespace remeshd
