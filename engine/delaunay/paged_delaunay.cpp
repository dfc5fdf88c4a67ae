#include "engine/delaunay/paged_delaunay.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "engine/mesh/circumball.h"

namespace remeshd {

PagedDelaunay::PagedDelaunay(const DelaunayMesh& mesh, std::vector<std::int32_t>& to)
    : points_(mesh.positions()) {
  std::copy_n(mesh.points_.begin(), kSuper, super_.begin());
  const auto lowest = [](const Slot& s) {
    std::uint32_t low = ~0U;  // the super vertices as the last of all
    for (const std::int32_t v : s.v) low = std::min(low, static_cast<std::uint32_t>(v - kSuper));
    return low;
  };
  std::vector<std::int32_t> begin(points_.size() + 2, 0);
  for (const Slot& s : mesh.slots_)
    if (s.v[0] != DelaunayMesh::kDead)
      ++begin[std::min<std::size_t>(lowest(s), points_.size()) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  to.assign(mesh.slots_.size(), -1);
  for (std::size_t t = 0; t < to.size(); ++t)
    if (const Slot& s = mesh.slots_[t]; s.v[0] != DelaunayMesh::kDead)
      to[t] = begin[std::min<std::size_t>(lowest(s), points_.size())]++;
  take_over(mesh.slots_, to, mesh.size());
}

template <class Slots>
void PagedDelaunay::take_over(const Slots& from, std::span<const std::int32_t> to,
                              std::size_t count) {
  CowVector<Slot> slots(count, {});
  std::vector<std::span<Slot>> pages;
  for (std::size_t k = 0; k < slots.pages(); ++k) pages.push_back(slots.edit_page(k));
  for (std::size_t t = 0; t < to.size(); ++t) {
    if (to[t] < 0) continue;
    const auto at = static_cast<std::size_t>(to[t]);
    Slot& s = pages[at / slots.kPage][at % slots.kPage];
    s = from[t];
    for (FacetRef& n : s.n)
      if (n.is_tet()) n = {to[n.tet()], n.corner()};
  }
  slots_ = std::move(slots);
  boxes_.resize(slots_.pages());
  for (std::size_t k = 0; k < boxes_.size(); ++k) measure_page(k);
}

void PagedDelaunay::measure_page(std::size_t page) {
  Box box;
  for (const Slot& s : slots_.page(page)) {
    if (s.v[0] == DelaunayMesh::kDead) continue;
    for (const std::int32_t v : s.v)
      if (v >= kSuper) box.add(point(v));
  }
  boxes_[page] = box;
}

void PagedDelaunay::measure_pages(std::span<const std::int32_t> slots) {
  boxes_.resize(slots_.pages());
  std::vector<std::uint8_t> done(boxes_.size(), 0);
  for (const std::int32_t s : slots) {
    const std::size_t page = static_cast<std::size_t>(s) / CowVector<Slot>::kPage;
    if (std::exchange(done[page], 1) == 0) measure_page(page);
  }
}

DelaunayMesh PagedDelaunay::cut(std::span<const std::int32_t> slots,
                                std::span<const std::int32_t> names, std::int32_t count,
                                Cut& cut) const {
  DelaunayMesh patch;
  patch.points_.assign(super_.begin(), super_.end());
  patch.points_.resize(static_cast<std::size_t>(count) + kSuper);
  std::vector<std::int32_t> number(slots_.size(), -1);
  for (std::size_t k = 0; k < slots.size(); ++k) number[slots[k]] = static_cast<std::int32_t>(k);
  cut.slots.assign(slots.begin(), slots.end());
  cut.exterior.clear();
  patch.slots_.reserve(slots.size());
  for (const std::int32_t t : slots) {
    Slot s = slots_[t];
    for (int i = 0; i < 4; ++i) {
      if (s.v[i] >= kSuper) {
        const std::int32_t v = names[s.v[i] - kSuper] + kSuper;
        patch.points_[v] = point(s.v[i]);
        s.v[i] = v;
      }
      const FacetRef across = s.n[i];
      if (!across.is_tet()) continue;
      if (const std::int32_t neighbour = number[across.tet()]; neighbour >= 0) {
        s.n[i] = {neighbour, across.corner()};
      } else {
        s.n[i] = FacetRef::beyond(static_cast<std::int32_t>(cut.exterior.size()));
        cut.exterior.push_back(across);
        patch.exterior_.push_back(point(slots_[across.tet()].v[across.corner()]));
      }
    }
    patch.slots_.push_back(s);
  }
  return patch;
}

std::int32_t PagedDelaunay::allocate() {
  if (free_.empty()) {
    slots_.resize(slots_.size() + 1);
    return static_cast<std::int32_t>(slots_.size()) - 1;
  }
  const std::int32_t t = free_.back();
  free_.pop_back();
  return t;
}

std::vector<std::int32_t> PagedDelaunay::put_back(const DelaunayMesh& patch, const Cut& cut,
                                                  std::span<const std::int32_t> names,
                                                  std::int32_t count) {
  if (slots_.empty()) {  // into a mesh without tets: all of this one
    std::vector<std::int32_t> place;
    *this = PagedDelaunay(patch, place);
    return place;
  }
  points_.resize(count);
  std::vector<std::uint8_t> moved(names.size() + kSuper, 0);
  for (std::size_t n = 0; n < names.size(); ++n) {
    if (names[n] < 0 || points_[names[n]] == patch.points_[n + kSuper]) continue;
    points_.edit(names[n]) = patch.points_[n + kSuper];
    moved[n + kSuper] = 1;
  }
  if (!cut.slots.empty() && cut.exterior.empty()) {  // all of the mesh, maybe in larger bounds
    for (std::int32_t v = 0; v < kSuper; ++v) moved[v] = super_[v] == patch.points_[v] ? 0 : 1;
    std::copy_n(patch.points_.begin(), kSuper, super_.begin());
  }
  std::vector<std::int32_t> changed;
  std::vector<std::int32_t> place(std::max(patch.slots_.size(), cut.slots.size()), -1);
  for (std::size_t t = 0; t < cut.slots.size(); ++t) {
    if (t < patch.slots_.size() && patch.slots_[t].v[0] != DelaunayMesh::kDead) {
      place[t] = cut.slots[t];
      continue;
    }
    slots_.edit(cut.slots[t]).v[0] = DelaunayMesh::kDead;
    free_.push_back(cut.slots[t]);
    changed.push_back(cut.slots[t]);
  }
  for (std::size_t t = cut.slots.size(); t < patch.slots_.size(); ++t)
    if (patch.slots_[t].v[0] != DelaunayMesh::kDead) place[t] = allocate();
  for (std::size_t t = 0; t < patch.slots_.size(); ++t) {
    if (place[t] < 0) continue;
    Slot s = patch.slots_[t];
    int moves = 0;
    for (int i = 0; i < 4; ++i) {
      moves |= moved[s.v[i]];
      if (s.v[i] >= kSuper) s.v[i] = names[s.v[i] - kSuper] + kSuper;
      const FacetRef across = s.n[i];
      if (across.is_tet()) {
        s.n[i] = {place[across.tet()], across.corner()};
      } else if (across.is_beyond()) {
        const FacetRef outer = cut.exterior[across.exterior()], here(place[t], i);
        s.n[i] = outer;
        if (slots_[outer.tet()].n[outer.corner()] != here)
          slots_.edit(outer.tet()).n[outer.corner()] = here;
      }
    }
    const bool same = slots_[place[t]] == s;
    if (!same) slots_.edit(place[t]) = s;
    if (!same || moves != 0) changed.push_back(place[t]);
  }
  measure_pages(changed);
  return place;
}

void PagedDelaunay::rename_last(std::span<const std::int32_t> names, std::int32_t count) {
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k] >= 0) points_.set(names[k], points_[count + k]);
  Box renamed;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k] >= 0) renamed.add(points_[count + k]);
  points_.resize(count);
  const std::int32_t end = count + kSuper;
  for_each_slot_near([&](const Box& box) { return !intersection(box, renamed).empty(); },
                     [&](std::int32_t t) {
                       const auto& v = slots_[t].v;
                       if (v[0] < end && v[1] < end && v[2] < end && v[3] < end) return;
                       for (std::int32_t& w : slots_.edit(t).v)
                         if (w >= end) w = names[w - end] + kSuper;
                     });
}

std::vector<std::int32_t> PagedDelaunay::close_gaps() {
  std::vector<std::int32_t> to(slots_.size(), -1);
  std::int32_t next = 0;
  for (std::size_t t = 0; t < slots_.size(); ++t)
    if (slots_[t].v[0] != DelaunayMesh::kDead) to[t] = next++;
  take_over(slots_, to, static_cast<std::size_t>(next));
  free_ = {};
  return to;
}

PagedDelaunay::Ball PagedDelaunay::ball(std::int32_t slot) const {
  const auto& v = slots_[slot].v;
  // Relative to a node: a super vertex is far away, and rounding would be worse.
  const std::int32_t origin = *std::ranges::max_element(v);
  const Vec3& a = point(origin);
  std::array<Vec3, 3> d;
  int k = 0;
  for (const std::int32_t w : v)
    if (w != origin) d[k++] = point(w) - a;
  const Vec3 centre = to_circumcentre(d[0], d[1], d[2]);
  return {a + centre, norm(centre)};
}

bool PagedDelaunay::consistent() const {
  const auto slots = static_cast<std::int32_t>(slots_.size());
  const auto vertices = static_cast<std::int32_t>(points_.size()) + kSuper;
  bool good = boxes_.size() == slots_.pages();
  slots_.for_each([&](std::size_t index, const Slot& slot) {
    if (slot.v[0] == DelaunayMesh::kDead) return;
    for (int i = 0; i < 4; ++i) {
      good &= slot.v[i] >= 0 && slot.v[i] < vertices;
      const FacetRef other = slot.n[i], here(static_cast<std::int32_t>(index), i);
      if (other.is_none()) continue;
      good &= other.is_tet() && other.tet() < slots && in_use(other.tet()) &&
              slots_[other.tet()].n[other.corner()] == here;
    }
  });
  for (const std::int32_t slot : free_)
    good &= slot >= 0 && slot < slots && slots_[slot].v[0] == DelaunayMesh::kDead;
  return good;
}

}  // namespace remeshd
