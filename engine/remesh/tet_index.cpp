#include "engine/remesh/tet_index.h"

#include <algorithm>
#include <bit>

namespace remeshd {

namespace {
std::size_t hash(const Tet& t) {
  std::uint64_t h = 0;
  for (const std::int32_t n : t) h = (h ^ static_cast<std::uint32_t>(n)) * 0x9E3779B97F4A7C15ULL;
  return h ^ (h >> 29);
}
}  // namespace

Tet sorted_nodes(Tet t) {
  if (t[0] > t[1]) std::swap(t[0], t[1]);
  if (t[2] > t[3]) std::swap(t[2], t[3]);
  if (t[0] > t[2]) std::swap(t[0], t[2]);
  if (t[1] > t[3]) std::swap(t[1], t[3]);
  if (t[1] > t[2]) std::swap(t[1], t[2]);
  return t;
}

TetIndex::TetIndex(std::span<const Tet> tets) {
  sorted_.reserve(tets.size());
  table_.assign(std::bit_ceil(2 * tets.size() + 2), -1);
  for (const Tet& t : tets) {
    sorted_.push_back(sorted_nodes(t));
    std::size_t at = hash(sorted_.back()) & (table_.size() - 1);
    while (table_[at] >= 0) at = (at + 1) & (table_.size() - 1);
    table_[at] = static_cast<std::int32_t>(sorted_.size()) - 1;
  }
}

std::int32_t TetIndex::find(const Tet& tet) const {
  const Tet key = sorted_nodes(tet);
  std::size_t at = hash(key) & (table_.size() - 1);
  while (table_[at] >= 0 && sorted_[table_[at]] != key) at = (at + 1) & (table_.size() - 1);
  return table_[at];
}

}  // namespace remeshd
