#include "engine/delaunay/delaunay_mesh.h"

#include <bit>

#include "engine/base/hilbert.h"
#include "engine/kernel/predicates.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

namespace {

struct DelaunayLimits {
  int nodes_per_poll = 512;
  double super_distance = 12;  ///< x diagonal; hull facets are Delaunay long before that
  double near = 0.25;          ///< x the distance of the super vertices: well within them
  std::size_t starts = 256;    ///< tets of a patch, the nearest of which a walk starts from
};
constexpr DelaunayLimits kDelaunayLimits;

std::array<Vec3, 4> super_vertices(const Box& bounds) {
  const Vec3 c = 0.5 * (bounds.lo + bounds.hi);
  const double r = kDelaunayLimits.super_distance * std::fmax(bounds.diagonal(), 1e-300);
  return {c + Vec3{r, r, r}, c + Vec3{r, -r, -r}, c + Vec3{-r, r, -r}, c + Vec3{-r, -r, r}};
}

/// Whether b is a rotation of a.
bool same_turn(const std::array<std::int32_t, 3>& a, const std::array<std::int32_t, 3>& b) {
  return (a[0] == b[0] && a[1] == b[1]) || (a[0] == b[1] && a[1] == b[2]) ||
         (a[0] == b[2] && a[1] == b[0]);
}

}  // namespace

DelaunayMesh::DelaunayMesh(std::span<const Vec3> far) : points_(far.begin(), far.begin() + kSuper) {
  Slot s{{0, 1, 2, 3}, {}};
  s.n.fill(FacetRef::none());
  if (kernel::orientation(points_[0], points_[1], points_[2], points_[3]) < 0)
    std::swap(s.v[2], s.v[3]);
  slots_.push_back(s);
}

DelaunayMesh::DelaunayMesh(const Box& bounds)
    : DelaunayMesh(std::span<const Vec3>(super_vertices(bounds))) {}

bool DelaunayMesh::encloses(const Box& box) const {
  const Vec3 centre = 0.25 * (points_[0] + points_[1] + points_[2] + points_[3]);
  const double reach = kDelaunayLimits.near * distance(points_[0], centre);
  const Vec3 half = 0.5 * (box.hi - box.lo);
  return distance(0.5 * (box.lo + box.hi), centre) + norm(half) <= reach;
}

void DelaunayMesh::insert(std::span<const Vec3> positions, std::span<const std::int32_t> nodes,
                          const Run& run) {
  if (nodes.empty()) return;
  Box box;
  std::int32_t last = 0;
  for (const std::int32_t node : nodes) {
    box.add(positions[node]);
    last = std::max(last, node);
  }
  if (points_.size() < static_cast<std::size_t>(last) + 1 + kSuper)
    points_.resize(last + 1 + kSuper);
  int count = 0;
  for (const std::int32_t node : insertion_order(positions, nodes, box)) {
    if (count++ % kDelaunayLimits.nodes_per_poll == 0) run.poll();
    points_[node + kSuper] = positions[node];
    insert_one(node + kSuper);
    if (patch_too_small_) return;  // it may not be a Delaunay mesh any more
  }
}

bool DelaunayMesh::conflicts(std::int32_t tet, const Vec3& p) const {
  const auto& v = slots_[tet].v;
  return kernel::in_sphere(points_[v[0]], points_[v[1]], points_[v[2]], points_[v[3]], p) > 0;
}

/// The tet that holds p or, where the way to it leaves the patch, -1.
std::int32_t DelaunayMesh::walk(std::int32_t from_slot, const Vec3& p) const {
  std::int32_t t = from_slot;
  std::int32_t from = -1;
  const auto exterior = [&](const Slot& s, unsigned i) {
    const auto& f = kTetFacets[i];
    return kernel::orientation(points_[s.v[f[0]]], points_[s.v[f[1]]], points_[s.v[f[2]]], p) > 0;
  };
  // Visibility walk; the facet tried first rotates, which keeps it from going round in circles.
  for (unsigned step = 0;; ++step) {
    const Slot& s = slots_[t];
    bool moved = false;
    for (unsigned k = 0; k < 4; ++k) {
      const unsigned i = (k + step) & 3U;
      if (!s.n[i].is_tet() || s.n[i].tet() == from || !exterior(s, i)) continue;
      from = t;
      t = s.n[i].tet();
      moved = true;
      break;
    }
    if (moved) continue;
    for (unsigned i = 0; i < 4; ++i)
      if (s.n[i].is_beyond() && exterior(s, i)) return -1;
    return t;
  }
}

std::int32_t DelaunayMesh::locate(const Vec3& p) const {
  if (const std::int32_t t = walk(hint_, p); t >= 0) return t;
  // A patch may be non-convex or in pieces: walk from the nearest of some of its tets, else test
  // all.
  const std::size_t stride = std::max<std::size_t>(1, slots_.size() / kDelaunayLimits.starts);
  std::int32_t nearest = -1;
  for (std::size_t t = 0; t < slots_.size(); t += stride) {
    if (slots_[t].v[0] == kDead) continue;
    const auto at = [&](std::int32_t slot) { return norm2(points_[slots_[slot].v[0]] - p); };
    if (nearest < 0 || at(static_cast<std::int32_t>(t)) < at(nearest))
      nearest = static_cast<std::int32_t>(t);
  }
  if (nearest >= 0)
    if (const std::int32_t t = walk(nearest, p); t >= 0) return t;
  const auto holds = [&](const Slot& s) {
    return s.v[0] != kDead && std::ranges::none_of(kTetFacets, [&](const auto& f) {
             return kernel::orientation(points_[s.v[f[0]]], points_[s.v[f[1]]], points_[s.v[f[2]]],
                                        p) > 0;
           });
  };
  const auto found = std::ranges::find_if(slots_, holds);
  return found == slots_.end() ? -1 : static_cast<std::int32_t>(found - slots_.begin());
}

std::int32_t DelaunayMesh::allocate() {
  if (!free_.empty()) {
    const std::int32_t t = free_.back();
    free_.pop_back();
    return t;
  }
  slots_.emplace_back();
  return static_cast<std::int32_t>(slots_.size()) - 1;
}

std::int32_t DelaunayMesh::number_cavity_vertices() {
  std::vector<Scratch::Name>& names = scratch_.names;
  if (names.size() < points_.size()) names.resize(points_.size(), {0, 0});
  std::int32_t next = 0;
  for (CavityFacet& r : scratch_.cavity_facets)
    for (int i = 0; i < 3; ++i) {
      Scratch::Name& name = names[r.v[i]];
      const bool fresh = name.epoch != scratch_.epoch;
      name.name = fresh ? next : name.name;
      name.epoch = scratch_.epoch;
      next += fresh ? 1 : 0;
      r.name[i] = name.name;
    }
  return next;
}

void DelaunayMesh::connect_small_cavity() {
  // Each edge of the cavity's boundary is in two of its facets, once in either direction.
  FacetRef* at = scratch_.at_edge.data();
  const auto place = [](std::int32_t a, std::int32_t b) { return a * kFewVertices + b; };
  for (const CavityFacet& r : scratch_.cavity_facets) {
    at[place(r.name[1], r.name[2])] = {r.tet, 0};
    at[place(r.name[2], r.name[0])] = {r.tet, 1};
    at[place(r.name[0], r.name[1])] = {r.tet, 2};
  }
  for (const CavityFacet& r : scratch_.cavity_facets) {
    auto& n = slots_[r.tet].n;
    n[0] = at[place(r.name[2], r.name[1])];
    n[1] = at[place(r.name[0], r.name[2])];
    n[2] = at[place(r.name[1], r.name[0])];
  }
}

void DelaunayMesh::connect_large_cavity() {
  auto& edges = scratch_.edges;
  if (const std::size_t least = 6 * scratch_.cavity_facets.size(); edges.size() < least)
    edges.assign(std::bit_ceil(least), EdgeEntry{});
  for (const CavityFacet& r : scratch_.cavity_facets) {
    connect({r.tet, 0}, r.v[1], r.v[2]);
    connect({r.tet, 1}, r.v[0], r.v[2]);
    connect({r.tet, 2}, r.v[0], r.v[1]);
  }
}

void DelaunayMesh::connect(FacetRef facet, std::int32_t a, std::int32_t b) {
  if (a > b) std::swap(a, b);
  const std::uint64_t key = (static_cast<std::uint64_t>(a) << 32) | static_cast<std::uint32_t>(b);
  auto& edges = scratch_.edges;
  const std::uint32_t epoch = scratch_.epoch;
  const std::size_t mask = edges.size() - 1;
  std::size_t at = (key * 0x9E3779B97F4A7C15ULL >> 40) & mask;
  while (edges[at].epoch == epoch && edges[at].key != key) at = (at + 1) & mask;
  if (edges[at].epoch == epoch)
    join(facet, edges[at].facet);
  else
    edges[at] = {key, facet, epoch};
}

bool DelaunayMesh::insert_one(std::int32_t vertex) {
  const Vec3 p = points_[vertex];
  const std::int32_t start = locate(p);
  if (start < 0) {
    patch_too_small_ = true;
    return false;
  }
  if (!conflicts(start, p)) return false;  // p is at one of its corners

  scratch_.begin(slots_.size());
  auto& seen = scratch_.seen;
  auto& cavity = scratch_.cavity;
  auto& cavity_facets = scratch_.cavity_facets;
  const std::uint32_t within = 2 * scratch_.epoch, outside = within + 1;
  cavity.assign(1, start);
  cavity_facets.clear();
  seen[start] = within;
  for (std::size_t k = 0; k < cavity.size(); ++k) {
    const Slot& s = slots_[cavity[k]];
    for (int i = 0; i < 4; ++i) {
      const FacetRef across = s.n[i];
      const auto& f = kTetFacets[i];
      if (across.is_tet()) {
        const std::int32_t t = across.tet();
        if (seen[t] == within) continue;
        if (seen[t] != outside) {
          if (conflicts(t, p)) {
            seen[t] = within;
            cavity.push_back(t);
            continue;
          }
          seen[t] = outside;
        }
      }
      patch_too_small_ |=
          across.is_beyond() && kernel::in_sphere(points_[s.v[f[0]]], points_[s.v[f[1]]],
                                                  points_[s.v[f[2]]], apex_position(across), p) > 0;
      // kTetFacets turns outward; seen from p, inside, the other way round is positive.
      cavity_facets.push_back({across, {s.v[f[0]], s.v[f[2]], s.v[f[1]]}});
    }
  }
  for (const std::int32_t t : cavity) release(t);
  for (CavityFacet& r : cavity_facets) {
    r.tet = allocate();
    Slot& s = slots_[r.tet];
    s.v = {r.v[0], r.v[1], r.v[2], vertex};
    s.n.fill(FacetRef::none());
    join({r.tet, 3}, r.outer);
    hint_ = r.tet;
  }
  // A table of pairs grows by the square, and a cavity may be large: a node inserted inside of a
  // sphere with many nodes on it sees all of them.
  if (number_cavity_vertices() <= kFewVertices)
    connect_small_cavity();
  else
    connect_large_cavity();
  return true;
}

bool DelaunayMesh::remove(std::span<const std::int32_t> nodes, const Run& run) {
  if (nodes.empty()) return true;
  std::vector<std::uint8_t> role(points_.size(), 0);  // 1: goes, 2: round a hole
  for (const std::int32_t node : nodes) role[node + kSuper] = 1;
  std::vector<std::uint8_t> gone(slots_.size(), 0);
  for (std::size_t t = 0; t < slots_.size(); ++t) {
    const auto& v = slots_[t].v;
    if (v[0] == kDead) continue;
    gone[t] = role[v[0]] == 1 || role[v[1]] == 1 || role[v[2]] == 1 || role[v[3]] == 1;
  }
  std::vector<HoleFacet> facets;
  std::vector<std::int32_t> round;  // nodes round the holes
  for (std::size_t t = 0; t < slots_.size(); ++t) {
    if (!gone[t]) continue;
    const Slot& s = slots_[t];
    for (int i = 0; i < 4; ++i) {
      if (role[s.v[i]] == 0) {
        role[s.v[i]] = 2;
        if (s.v[i] >= kSuper) round.push_back(s.v[i] - kSuper);
      }
      if (s.n[i].is_tet() && gone[s.n[i].tet()]) continue;
      const auto& f = kTetFacets[i];
      // At a patch's boundary: no filling has a facet with a node that goes.
      if (role[s.v[f[0]]] == 1 || role[s.v[f[1]]] == 1 || role[s.v[f[2]]] == 1) return false;
      facets.push_back({HoleFacet::key_of(s.v[f[0]], s.v[f[1]], s.v[f[2]]),
                        s.n[i],
                        {s.v[f[0]], s.v[f[2]], s.v[f[1]]}});
    }
  }
  std::sort(facets.begin(), facets.end());
  std::vector<Vec3> positions(points_.size() - kSuper);
  for (const std::int32_t n : round) positions[n] = points_[n + kSuper];
  DelaunayMesh filling{std::span<const Vec3>(points_)};
  filling.insert(positions, round, run);
  const std::optional<std::vector<Fill>> fill = match_hole(filling, facets, run);
  if (!fill) return false;

  for (std::size_t t = 0; t < slots_.size(); ++t)
    if (gone[t]) release(static_cast<std::int32_t>(t));
  std::vector<std::int32_t> place(filling.slots_.size(), -1);
  for (const Fill& f : *fill) place[f.tet] = allocate();
  for (const Fill& f : *fill) {
    const Slot& s = filling.slots_[f.tet];
    hint_ = place[f.tet];
    slots_[hint_].v = s.v;
    for (int i = 0; i < 4; ++i) {
      if (f.facet[i] < 0)
        slots_[hint_].n[i] = {place[s.n[i].tet()], s.n[i].corner()};
      else
        join({hint_, i}, facets[f.facet[i]].outer);
    }
  }
  return true;
}

std::optional<std::vector<DelaunayMesh::Fill>> DelaunayMesh::match_hole(
    const DelaunayMesh& filling, const std::vector<HoleFacet>& facets, const Run& run) {
  Polling poll(run);
  std::vector<std::uint8_t> at_wall(filling.points_.size(), 0);
  std::vector<std::uint32_t> begin(filling.points_.size() + 1, 0);  // by lowest vertex
  for (const HoleFacet& w : facets) {
    for (const std::int32_t v : w.v) at_wall[v] = 1;
    ++begin[w.key[0] + 1];
  }
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  const auto facet_at = [&](const Slot& s, int i) -> std::int32_t {
    const auto& f = kTetFacets[i];
    if (!(at_wall[s.v[f[0]]] & at_wall[s.v[f[1]]] & at_wall[s.v[f[2]]])) return -1;
    const auto key = HoleFacet::key_of(s.v[f[0]], s.v[f[1]], s.v[f[2]]);
    for (std::uint32_t w = begin[key[0]]; w < begin[key[0] + 1]; ++w)
      // Seen from inside, a facet turns the other way than the tet's own outward facet.
      if (facets[w].has_key(key) && same_turn(facets[w].v, {s.v[f[0]], s.v[f[2]], s.v[f[1]]}))
        return static_cast<std::int32_t>(w);
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
      if (facet_at(filling.slots_[t], i) >= 0) take(static_cast<std::int32_t>(t));
  }
  for (std::size_t k = 0; k < fill.size(); ++k) {
    poll();
    const Slot& s = filling.slots_[fill[k].tet];
    for (int i = 0; i < 4; ++i) {
      const std::int32_t facet = facet_at(s, i);
      fill[k].facet[i] = facet;
      if (facet >= 0) {
        ++met;
      } else {
        if (!s.n[i].is_tet()) return std::nullopt;  // out through the super vertices
        take(s.n[i].tet());
      }
    }
  }
  if (met != facets.size()) return std::nullopt;
  return fill;
}

void DelaunayMesh::rename(std::span<const std::int32_t> names, std::int32_t count) {
  std::vector<Vec3> points(points_.begin(), points_.begin() + kSuper);
  points.resize(static_cast<std::size_t>(count) + kSuper);
  const std::size_t nodes = std::min(names.size(), points_.size() - kSuper);
  for (std::size_t n = 0; n < nodes; ++n)
    if (names[n] >= 0) points[names[n] + kSuper] = points_[n + kSuper];
  for (Slot& s : slots_) {
    if (s.v[0] == kDead) continue;
    for (std::int32_t& v : s.v)
      if (v >= kSuper) v = names[v - kSuper] + kSuper;
  }
  points_ = std::move(points);
}

}  // namespace remeshd
