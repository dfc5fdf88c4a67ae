#include "engine/patch/tet_index.h"

#include <algorithm>

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
                   std::size_t node_count, Polling& poll)
    : begin_(node_count + 1, 0) {
  for (std::size_t k = 0; k < tets.size(); ++k)
    if (left_out[k] == 0) ++begin_[std::ranges::min(tets[k]) + 1];
  for (std::size_t n = 1; n < begin_.size(); ++n) begin_[n] += begin_[n - 1];
  entries_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t k = 0; k < tets.size(); ++k) {
    poll();
    if (left_out[k] != 0) continue;
    const Tet t = sorted_nodes(tets[k]);
    entries_[next[t[0]]++] = {{t[1], t[2], t[3]}, static_cast<std::int32_t>(k)};
  }
}

std::int32_t TetIndex::find(const Tet& tet) const {
  const Tet t = sorted_nodes(tet);
  if (static_cast<std::size_t>(t[0]) + 1 >= begin_.size()) return -1;
  for (std::uint32_t e = begin_[t[0]]; e < begin_[t[0] + 1]; ++e) {
    const auto& others = entries_[e].others;
    if (others[0] == t[1] && others[1] == t[2] && others[2] == t[3]) return entries_[e].tet;
  }
  return -1;
}

}  // namespace remeshd
