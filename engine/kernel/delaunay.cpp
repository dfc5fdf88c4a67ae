#include "engine/kernel/delaunay.h"

#include <algorithm>
#include <cassert>

#include "engine/base/hilbert.h"
#include "engine/kernel/predicates.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd::kernel {

namespace {

constexpr int kPollEvery = 512;
constexpr double kFarDistance = 12;  // diagonals; hull facets are Delaunay long before that
constexpr double kNear = 0.25;       // of the distance of the far corners: well within them

std::array<Vec3, 4> far_corners(const Box& bounds) {
  const Vec3 c = 0.5 * (bounds.lo + bounds.hi);
  const double r = kFarDistance * std::fmax(bounds.diagonal(), 1e-300);
  return {c + Vec3{r, r, r}, c + Vec3{r, -r, -r}, c + Vec3{-r, r, -r}, c + Vec3{-r, -r, r}};
}

std::array<std::int32_t, 3> sorted_key(std::int32_t a, std::int32_t b, std::int32_t c) {
  if (a > b) std::swap(a, b);
  if (b > c) std::swap(b, c);
  if (a > b) std::swap(a, b);
  return {a, b, c};
}

/// Whether b is a rotation of a.
bool same_turn(const std::array<std::int32_t, 3>& a, const std::array<std::int32_t, 3>& b) {
  return (a[0] == b[0] && a[1] == b[1]) || (a[0] == b[1] && a[1] == b[2]) ||
         (a[0] == b[2] && a[1] == b[0]);
}

}  // namespace

Delaunay::Delaunay(std::span<const Vec3> far)
    : points_(far.begin(), far.begin() + kFar), edges_(kEdgeTable) {
  Slot s{{0, 1, 2, 3}, {-1, -1, -1, -1}};
  if (orientation(points_[0], points_[1], points_[2], points_[3]) < 0) std::swap(s.v[2], s.v[3]);
  slots_.push_back(s);
  seen_.push_back(0);
}

Delaunay::Delaunay(const Box& bounds) : Delaunay(std::span<const Vec3>(far_corners(bounds))) {}

bool Delaunay::encloses(const Box& box) const {
  const Vec3 centre = 0.25 * (points_[0] + points_[1] + points_[2] + points_[3]);
  const double reach = kNear * distance(points_[0], centre);
  const Vec3 half = 0.5 * (box.hi - box.lo);
  return distance(0.5 * (box.lo + box.hi), centre) + norm(half) <= reach;
}

void Delaunay::insert(std::span<const Vec3> positions, std::span<const std::int32_t> nodes,
                      const Run& run) {
  if (nodes.empty()) return;
  Box box;
  std::int32_t last = 0;
  for (const std::int32_t node : nodes) {
    box.add(positions[node]);
    last = std::max(last, node);
  }
  if (points_.size() < static_cast<std::size_t>(last) + 1 + kFar) points_.resize(last + 1 + kFar);
  int count = 0;
  for (const std::int32_t node : insertion_order(positions, nodes, box)) {
    if (count++ % kPollEvery == 0) run.poll();
    points_[node + kFar] = positions[node];
    insert_one(node + kFar);
  }
}

bool Delaunay::conflicts(std::int32_t tet, const Vec3& p) const {
  const auto& v = slots_[tet].v;
  return in_sphere(points_[v[0]], points_[v[1]], points_[v[2]], points_[v[3]], p) > 0;
}

std::int32_t Delaunay::locate(const Vec3& p) const {
  std::int32_t t = hint_;
  std::int32_t from = -1;
  // Visibility walk; the facet tried first rotates, which keeps it from going round in circles.
  for (unsigned step = 0;; ++step) {
    const Slot& s = slots_[t];
    bool moved = false;
    for (unsigned k = 0; k < 4; ++k) {
      const unsigned i = (k + step) & 3U;
      if (s.n[i] < 0 || (s.n[i] >> 2) == from) continue;
      const auto& f = kTetFacets[i];
      if (orientation(points_[s.v[f[0]]], points_[s.v[f[1]]], points_[s.v[f[2]]], p) > 0) {
        from = t;
        t = s.n[i] >> 2;
        moved = true;
        break;
      }
    }
    if (!moved) return t;
  }
}

std::int32_t Delaunay::allocate() {
  if (!free_.empty()) {
    const std::int32_t t = free_.back();
    free_.pop_back();
    return t;
  }
  slots_.emplace_back();
  seen_.push_back(0);
  return static_cast<std::int32_t>(slots_.size()) - 1;
}

void Delaunay::link(std::int32_t facet, std::int32_t a, std::int32_t b) {
  if (a > b) std::swap(a, b);
  const std::uint64_t key = (static_cast<std::uint64_t>(a) << 32) | static_cast<std::uint32_t>(b);
  const std::size_t mask = edges_.size() - 1;
  std::size_t at = (key * 0x9E3779B97F4A7C15ULL >> 40) & mask;
  while (edges_[at].epoch == epoch_ && edges_[at].key != key) at = (at + 1) & mask;
  if (edges_[at].epoch != epoch_) {
    edges_[at] = {key, facet, epoch_};
    return;
  }
  const std::int32_t other = edges_[at].facet;
  slots_[facet >> 2].n[facet & 3] = other;
  slots_[other >> 2].n[other & 3] = facet;
}

bool Delaunay::insert_one(std::int32_t vertex) {
  const Vec3 p = points_[vertex];
  const std::int32_t start = locate(p);
  if (!conflicts(start, p)) return false;  // only a tet with a corner at p contains it in no sphere

  ++epoch_;
  cavity_.assign(1, start);
  rim_.clear();
  seen_[start] = 2 * epoch_;
  for (std::size_t k = 0; k < cavity_.size(); ++k) {
    const Slot& s = slots_[cavity_[k]];
    for (int i = 0; i < 4; ++i) {
      const std::int32_t across = s.n[i];
      const auto& f = kTetFacets[i];
      if (across >= 0) {
        const std::int32_t t = across >> 2;
        // 2 * epoch: in the cavity; 2 * epoch + 1: known to be outside.
        if (seen_[t] == 2 * epoch_) continue;
        if (seen_[t] != 2 * epoch_ + 1) {
          if (conflicts(t, p)) {
            seen_[t] = 2 * epoch_;
            cavity_.push_back(t);
            continue;
          }
          seen_[t] = 2 * epoch_ + 1;
        }
      }
      // kTetFacets turns outward; seen from p, inside, the other way round is positive.
      rim_.push_back({across, {s.v[f[0]], s.v[f[2]], s.v[f[1]]}});
    }
  }
  if (edges_.size() < 6 * rim_.size()) {
    std::size_t size = edges_.size();
    while (size < 6 * rim_.size()) size *= 2;
    edges_.assign(size, EdgeEntry{0, 0, 0});
  }
  for (const std::int32_t t : cavity_) {
    slots_[t].v[0] = kDead;
    free_.push_back(t);
  }
  for (const Rim& r : rim_) {
    const std::int32_t t = allocate();
    Slot& s = slots_[t];
    s.v = {r.v[0], r.v[1], r.v[2], vertex};
    s.n = {-1, -1, -1, r.outer};
    if (r.outer >= 0) slots_[r.outer >> 2].n[r.outer & 3] = 4 * t + 3;
    seen_[t] = 0;
    link(4 * t + 0, r.v[1], r.v[2]);
    link(4 * t + 1, r.v[0], r.v[2]);
    link(4 * t + 2, r.v[0], r.v[1]);
    hint_ = t;
  }
  return true;
}

bool Delaunay::remove(std::span<const std::int32_t> nodes, const Run& run) {
  if (nodes.empty()) return true;
  std::vector<std::uint8_t> role(points_.size(), 0);  // 1: goes, 2: at the rim of a hole
  for (const std::int32_t node : nodes) role[node + kFar] = 1;
  std::vector<std::uint8_t> gone(slots_.size(), 0);
  for (std::size_t t = 0; t < slots_.size(); ++t) {
    const auto& v = slots_[t].v;
    if (v[0] == kDead) continue;
    gone[t] = role[v[0]] == 1 || role[v[1]] == 1 || role[v[2]] == 1 || role[v[3]] == 1;
  }
  std::vector<Wall> walls;
  std::vector<std::int32_t> rim;
  for (std::size_t t = 0; t < slots_.size(); ++t) {
    if (!gone[t]) continue;
    const Slot& s = slots_[t];
    for (int i = 0; i < 4; ++i) {
      if (role[s.v[i]] == 0) {
        role[s.v[i]] = 2;
        if (s.v[i] >= kFar) rim.push_back(s.v[i] - kFar);
      }
      if (s.n[i] >= 0 && gone[s.n[i] >> 2]) continue;
      const auto& f = kTetFacets[i];
      walls.push_back(
          {sorted_key(s.v[f[0]], s.v[f[1]], s.v[f[2]]), s.n[i], {s.v[f[0]], s.v[f[2]], s.v[f[1]]}});
    }
  }
  // A wall is seen from inside its hole; the same three nodes may bound holes on both sides.
  std::sort(walls.begin(), walls.end(), [](const Wall& a, const Wall& b) {
    return a.key != b.key ? a.key < b.key : a.outer < b.outer;
  });
  std::vector<Vec3> positions(points_.size() - kFar);
  for (const std::int32_t n : rim) positions[n] = points_[n + kFar];
  Delaunay filling{std::span<const Vec3>(points_)};
  filling.insert(positions, rim, run);
  const std::optional<std::vector<Fill>> fill = fit(filling, walls, run);
  if (!fill) return false;

  for (std::size_t t = 0; t < slots_.size(); ++t) {
    if (!gone[t]) continue;
    slots_[t].v[0] = kDead;
    free_.push_back(static_cast<std::int32_t>(t));
  }
  std::vector<std::int32_t> place(filling.slots_.size(), -1);
  for (const Fill& f : *fill) place[f.tet] = allocate();
  for (const Fill& f : *fill) {
    Slot& s = slots_[place[f.tet]];
    s.v = filling.slots_[f.tet].v;
    seen_[place[f.tet]] = 0;
    for (int i = 0; i < 4; ++i) {
      if (f.wall[i] < 0) {
        const std::int32_t across = filling.slots_[f.tet].n[i];
        s.n[i] = 4 * place[across >> 2] + (across & 3);
        continue;
      }
      s.n[i] = walls[f.wall[i]].outer;
      if (s.n[i] >= 0) slots_[s.n[i] >> 2].n[s.n[i] & 3] = 4 * place[f.tet] + i;
    }
    hint_ = place[f.tet];
  }
  return true;
}

std::optional<std::vector<Delaunay::Fill>> Delaunay::fit(const Delaunay& filling,
                                                         const std::vector<Wall>& walls,
                                                         const Run& run) {
  Polling poll(run);
  const auto wall_at = [&](const Slot& s, int i) -> std::int32_t {
    const auto& f = kTetFacets[i];
    const auto key = sorted_key(s.v[f[0]], s.v[f[1]], s.v[f[2]]);
    auto at = std::lower_bound(walls.begin(), walls.end(), key,
                               [](const Wall& w, const auto& k) { return w.key < k; });
    for (; at != walls.end() && at->key == key; ++at)
      // Seen from inside, a wall turns the other way than the tet's own outward facet.
      if (same_turn(at->v, {s.v[f[0]], s.v[f[2]], s.v[f[1]]}))
        return static_cast<std::int32_t>(at - walls.begin());
    return -1;
  };
  std::vector<std::int32_t> inside(filling.slots_.size(), -1);
  std::vector<Fill> fill;
  const auto take = [&](std::int32_t t) {
    if (inside[t] >= 0) return;
    inside[t] = static_cast<std::int32_t>(fill.size());
    fill.push_back({t, {-1, -1, -1, -1}});
  };
  std::size_t met = 0;
  for (std::size_t t = 0; t < filling.slots_.size(); ++t) {
    poll();
    if (filling.slots_[t].v[0] == kDead) continue;
    for (int i = 0; i < 4; ++i)
      if (wall_at(filling.slots_[t], i) >= 0) take(static_cast<std::int32_t>(t));
  }
  for (std::size_t k = 0; k < fill.size(); ++k) {
    poll();
    const Slot& s = filling.slots_[fill[k].tet];
    for (int i = 0; i < 4; ++i) {
      const std::int32_t wall = wall_at(s, i);
      fill[k].wall[i] = wall;
      if (wall >= 0) {
        ++met;
      } else {
        if (s.n[i] < 0) return std::nullopt;  // out through the far corners
        take(s.n[i] >> 2);
      }
    }
  }
  if (met != walls.size()) return std::nullopt;
  return fill;
}

void Delaunay::rename(std::span<const std::int32_t> names, std::int32_t count) {
  std::vector<Vec3> points(points_.begin(), points_.begin() + kFar);
  points.resize(static_cast<std::size_t>(count) + kFar);
  for (Slot& s : slots_) {
    if (s.v[0] == kDead) continue;
    for (std::int32_t& v : s.v) {
      if (v < kFar) continue;
      const std::int32_t name = names[v - kFar] + kFar;
      points[name] = points_[v];
      v = name;
    }
  }
  points_ = std::move(points);
}

}  // namespace remeshd::kernel
