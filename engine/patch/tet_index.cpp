#include "engine/patch/tet_index.h"

#include <utility>

namespace remeshd {

SortedNodes sorted_nodes(const Tet& tet) {
  SortedNodes sorted{tet, true};
  const auto order = [&](int i, int j) {
    if (sorted.nodes[i] < sorted.nodes[j]) return;
    std::swap(sorted.nodes[i], sorted.nodes[j]);
    sorted.even = !sorted.even;
  };
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  return sorted;
}

TetIndex::TetIndex(std::span<const Tet> tets, std::span<const std::uint8_t> left_out,
                   std::size_t node_count, bool oriented, Polling& poll)
    : oriented_(oriented) {
  entries_ = grouped<Entry>(node_count, [&](const auto& visit) {
    for (std::size_t k = 0; k < tets.size(); ++k) {
      poll();
      if (left_out[k] != 0) continue;
      const auto [t, even] = sorted_nodes(tets[k]);
      visit(t[0], Entry{{t[1], t[2], t[3]}, static_cast<std::int32_t>(k), even});
    }
  });
}

std::int32_t TetIndex::find(const Tet& tet) const {
  const auto [t, even] = sorted_nodes(tet);
  if (static_cast<std::size_t>(t[0]) + 1 >= entries_.begin.size()) return -1;
  for (const Entry& entry : entries_[t[0]])
    if (entry.others[0] == t[1] && entry.others[1] == t[2] && entry.others[2] == t[3] &&
        (!oriented_ || entry.even == even))
      return entry.tet;
  return -1;
}

}  // namespace remeshd
