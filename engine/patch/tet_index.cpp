#include "engine/patch/tet_index.h"

#include <utility>

namespace remeshd {

Tet sorted_nodes(Tet t) {
  if (t[0] > t[1]) std::swap(t[0], t[1]);
  if (t[2] > t[3]) std::swap(t[2], t[3]);
  if (t[0] > t[2]) std::swap(t[0], t[2]);
  if (t[1] > t[3]) std::swap(t[1], t[3]);
  if (t[1] > t[2]) std::swap(t[1], t[2]);
  return t;
}

TetIndex::TetIndex(std::span<const Tet> tets, std::span<const std::uint8_t> left_out,
                   std::size_t node_count, Polling& poll) {
  entries_ = grouped<Entry>(node_count, [&](const auto& visit) {
    for (std::size_t k = 0; k < tets.size(); ++k) {
      poll();
      if (left_out[k] != 0) continue;
      const Tet t = sorted_nodes(tets[k]);
      visit(t[0], Entry{{t[1], t[2], t[3]}, static_cast<std::int32_t>(k)});
    }
  });
}

std::int32_t TetIndex::find(const Tet& tet) const {
  const Tet t = sorted_nodes(tet);
  if (static_cast<std::size_t>(t[0]) + 1 >= entries_.begin.size()) return -1;
  for (const auto& [others, number] : entries_[t[0]])
    if (others[0] == t[1] && others[1] == t[2] && others[2] == t[3]) return number;
  return -1;
}

}  // namespace remeshd
