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
}  // namespace

Delaunay::Delaunay(const Box& bounds) : edges_(256, EdgeEntry{0, 0, 0}) {
  const Vec3 c = 0.5 * (bounds.lo + bounds.hi);
  const double r = kFarDistance * std::fmax(bounds.diagonal(), 1e-300);
  points_ = {c + Vec3{r, r, r}, c + Vec3{r, -r, -r}, c + Vec3{-r, r, -r}, c + Vec3{-r, -r, r}};
  Slot s{{0, 1, 2, 3}, {-1, -1, -1, -1}};
  if (orientation(points_[0], points_[1], points_[2], points_[3]) < 0) std::swap(s.v[2], s.v[3]);
  slots_.push_back(s);
  seen_.push_back(0);
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

}  // namespace remeshd::kernel
