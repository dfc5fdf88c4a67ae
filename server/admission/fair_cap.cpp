#include "server/admission/fair_cap.h"

#include <algorithm>
#include <limits>

namespace remeshd {

std::uint64_t fair_cap(std::vector<std::uint64_t> amounts, std::uint64_t total) {
  std::ranges::sort(amounts);
  std::uint64_t left = total;
  for (std::size_t i = 0; i < amounts.size(); ++i) {
    const std::uint64_t share = left / (amounts.size() - i);
    if (amounts[i] > share) return share;
    left -= amounts[i];
  }
  return std::numeric_limits<std::uint64_t>::max();
}

}  // namespace remeshd
