// A part of a Delaunay mesh on its own, and back again.
#include <algorithm>

#include "engine/kernel/delaunay.h"

namespace remeshd::kernel {

Delaunay Delaunay::cut(std::span<const std::int32_t> slots, std::span<const std::int32_t> names,
                       std::int32_t count, Cut& cut) const {
  Delaunay part;
  part.points_.assign(points_.begin(), points_.begin() + kFar);
  part.points_.resize(static_cast<std::size_t>(count) + kFar);
  std::vector<std::int32_t> number(slots_.size(), -1);
  for (std::size_t k = 0; k < slots.size(); ++k) number[slots[k]] = static_cast<std::int32_t>(k);
  cut.slots.assign(slots.begin(), slots.end());
  cut.beyond.clear();
  part.slots_.reserve(slots.size());
  for (const std::int32_t t : slots) {
    Slot s = slots_[t];
    for (int i = 0; i < 4; ++i) {
      if (s.v[i] >= kFar) {
        const std::int32_t v = names[s.v[i] - kFar] + kFar;
        part.points_[v] = points_[s.v[i]];
        s.v[i] = v;
      }
      if (s.n[i] < 0) continue;
      const std::int32_t neighbour = number[s.n[i] >> 2];
      if (neighbour >= 0) {
        s.n[i] = 4 * neighbour + (s.n[i] & 3);
      } else {
        cut.beyond.push_back(s.n[i]);
        part.beyond_.push_back(points_[slots_[s.n[i] >> 2].v[s.n[i] & 3]]);
        s.n[i] = -1 - static_cast<std::int32_t>(cut.beyond.size());
      }
    }
    part.slots_.push_back(s);
  }
  return part;
}

std::vector<std::int32_t> Delaunay::put_back(const Delaunay& part, const Cut& cut,
                                             std::span<const std::int32_t> names,
                                             std::int32_t count) {
  points_.reserve(static_cast<std::size_t>(count) + kFar);
  points_.resize(static_cast<std::size_t>(count) + kFar);
  for (std::size_t n = 0; n < names.size(); ++n)
    if (names[n] >= 0) points_[names[n] + kFar] = part.points_[n + kFar];
  std::vector<std::int32_t> place(part.slots_.size(), -1);
  for (std::size_t t = 0; t < cut.slots.size(); ++t) {
    if (part.slots_[t].v[0] != kDead) {
      place[t] = cut.slots[t];
      continue;
    }
    slots_[cut.slots[t]].v[0] = kDead;
    free_.push_back(cut.slots[t]);
  }
  // No room to spare: this mesh stays while the part goes.
  const auto more = static_cast<std::size_t>(
      std::count_if(part.slots_.begin() + static_cast<std::ptrdiff_t>(cut.slots.size()),
                    part.slots_.end(), [](const Slot& s) { return s.v[0] != kDead; }));
  if (more > free_.size()) slots_.reserve(slots_.size() + more - free_.size());
  for (std::size_t t = cut.slots.size(); t < part.slots_.size(); ++t)
    if (part.slots_[t].v[0] != kDead) place[t] = allocate();
  for (std::size_t t = 0; t < part.slots_.size(); ++t) {
    if (place[t] < 0) continue;
    const Slot& from = part.slots_[t];
    Slot& to = slots_[place[t]];
    for (int i = 0; i < 4; ++i) {
      to.v[i] = from.v[i] < kFar ? from.v[i] : names[from.v[i] - kFar] + kFar;
      if (from.n[i] >= 0) {
        to.n[i] = 4 * place[from.n[i] >> 2] + (from.n[i] & 3);
      } else if (from.n[i] == -1) {
        to.n[i] = -1;
      } else {
        to.n[i] = cut.beyond[-2 - from.n[i]];
        slots_[to.n[i] >> 2].n[to.n[i] & 3] = 4 * place[t] + i;
      }
    }
    hint_ = place[t];
  }
  return place;
}

std::vector<std::int32_t> Delaunay::close_gaps() {
  std::vector<std::int32_t> to(slots_.size(), -1);
  std::int32_t next = 0;
  for (std::size_t t = 0; t < slots_.size(); ++t)
    if (slots_[t].v[0] != kDead) to[t] = next++;
  std::vector<Slot> slots;
  slots.reserve(static_cast<std::size_t>(next));
  for (Slot s : slots_) {
    if (s.v[0] == kDead) continue;
    for (std::int32_t& n : s.n)
      if (n >= 0) n = 4 * to[n >> 2] + (n & 3);
    slots.push_back(s);
  }
  slots_ = std::move(slots);
  free_ = {};
  hint_ = 0;
  return to;
}

}  // namespace remeshd::kernel
