// Moving nodes: Delaunay again by bistellar flips, and by taking out and putting in what flips
// cannot restore.
#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/base/parallel.h"
#include "engine/delaunay/delaunay_mesh.h"
#include "engine/kernel/predicates.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

namespace {

enum Role : std::uint8_t { kStill = 0, kMoved = 1, kHeld = 2, kUnflippable = 3 };

struct MotionLimits {
  double most_held = 0.25;          ///< share of the moved nodes, before flips do not pay any more
  int tries = 2;                    ///< of held nodes, once others have made room; more help few
  std::size_t tets_per_try = 5000;  ///< that a held node makes worth while
};
constexpr MotionLimits kLimits;

}  // namespace

bool DelaunayMesh::reinsert(std::span<const Vec3> positions, std::span<const std::int32_t> nodes,
                            const Run& run) {
  if (!remove(nodes, run)) return false;
  insert(positions, nodes, run);
  return true;
}

DelaunayMesh::Moved DelaunayMesh::move(std::span<const Vec3> positions,
                                       std::span<const std::int32_t> nodes, const Run& run) {
  std::vector<std::uint8_t> roles(points_.size(), kStill);
  std::vector<Vec3> old(points_.size());
  std::vector<std::int32_t> moved;
  for (const std::int32_t n : nodes) {
    if (points_[n + kSuper] == positions[n]) continue;
    moved.push_back(n);
    old[n + kSuper] = points_[n + kSuper];
  }
  if (moved.empty()) return Moved::Done;
  std::vector<std::int32_t> again, unflipped;
  std::vector<std::int32_t> going = moved;
  for (int k = 1;; ++k) {
    for (const std::int32_t n : going) {
      roles[n + kSuper] = kMoved;
      points_[n + kSuper] = positions[n];
    }
    const std::vector<std::int32_t> touched = tets_at_moved(roles, run);
    std::vector<std::int32_t> held = revert_inverted(touched, roles, old, run);
    retry(touched, positions, roles, held, run);
    if (k == 1 &&
        static_cast<double>(held.size()) > kLimits.most_held * static_cast<double>(moved.size())) {
      for (const std::int32_t n : moved) points_[n + kSuper] = old[n + kSuper];
      return Moved::TooFar;
    }
    flip_all(touched, unflipped, run);
    for (const std::int32_t n : going)
      if (roles[n + kSuper] == kMoved) roles[n + kSuper] = kStill;
    if (k == kLimits.tries || held.size() == going.size() ||
        held.size() * kLimits.tets_per_try < slots_.size()) {
      again = std::move(held);
      break;
    }
    going = std::move(held);
  }
  // What flips could not restore: the corners of a facet that is not Delaunay come out too.
  for (const std::int32_t facet : unflipped) {
    const Slot& s = slots_[facet >> 2];
    const std::int32_t across = s.v[0] == kDead ? -1 : s.n[facet & 3];
    if (across < 0 || !conflicts(facet >> 2, points_[slots_[across >> 2].v[across & 3]])) continue;
    for (const int c : kTetFacets[facet & 3]) {
      const std::int32_t v = s.v[c];
      if (v < kSuper || roles[v] == kHeld || roles[v] == kUnflippable) continue;
      roles[v] = kUnflippable;
      again.push_back(v - kSuper);
    }
  }
  std::vector<Vec3> places(points_.size() - kSuper);
  for (const std::int32_t n : again)
    places[n] = roles[n + kSuper] == kUnflippable ? points_[n + kSuper] : positions[n];
  return reinsert(places, again, run) ? Moved::Done : Moved::Failed;
}

std::vector<std::int32_t> DelaunayMesh::tets_at_moved(const std::vector<std::uint8_t>& roles,
                                                      const Run& run) const {
  return collect_in_blocks<std::int32_t>(
      slots_.size(), kCheapBlock, run,
      [&](std::size_t begin, std::size_t end, std::vector<std::int32_t>& found) {
        run.poll();
        for (std::size_t t = begin; t < end; ++t) {
          const auto& v = slots_[t].v;
          if (v[0] == kDead) continue;
          if (roles[v[0]] == kMoved || roles[v[1]] == kMoved || roles[v[2]] == kMoved ||
              roles[v[3]] == kMoved)
            found.push_back(static_cast<std::int32_t>(t));
        }
      });
}

std::vector<std::int32_t> DelaunayMesh::revert_inverted(std::span<const std::int32_t> touched,
                                                        std::vector<std::uint8_t>& roles,
                                                        const std::vector<Vec3>& old,
                                                        const Run& run) {
  std::vector<std::int32_t> held;
  std::vector<std::uint8_t> fresh(points_.size(), 1);  // put back in the last sweep
  for (bool again = true; again;) {
    const auto back = collect_in_blocks<std::int32_t>(
        touched.size(), kCheapBlock, run,
        [&](std::size_t begin, std::size_t end, std::vector<std::int32_t>& found) {
          run.poll();
          for (const std::int32_t t : touched.subspan(begin, end - begin)) {
            const auto& v = slots_[t].v;
            if (!fresh[v[0]] && !fresh[v[1]] && !fresh[v[2]] && !fresh[v[3]]) continue;
            if (kernel::orientation(points_[v[0]], points_[v[1]], points_[v[2]], points_[v[3]]) > 0)
              continue;
            for (const std::int32_t n : v)
              if (roles[n] == kMoved) found.push_back(n);
          }
        });
    fresh.assign(points_.size(), 0);
    again = false;
    for (const std::int32_t v : back) {
      if (roles[v] == kHeld) continue;
      roles[v] = kHeld;
      fresh[v] = 1;
      points_[v] = old[v];
      held.push_back(v - kSuper);
      again = true;
    }
  }
  return held;
}

void DelaunayMesh::retry(std::span<const std::int32_t> touched, std::span<const Vec3> positions,
                         std::vector<std::uint8_t>& roles, std::vector<std::int32_t>& held,
                         const Run& run) {
  Polling poll(run);
  // The tets at each held vertex, by vertex.
  std::vector<std::uint32_t> end(points_.size() + 1, 0);
  const auto each = [&](auto&& f) {
    for (const std::int32_t t : touched) {
      poll();
      for (const std::int32_t v : slots_[t].v)
        if (roles[v] == kHeld) f(v, t);
    }
  };
  each([&](std::int32_t v, std::int32_t) { ++end[v + 1]; });
  for (std::size_t v = 1; v < end.size(); ++v) end[v] += end[v - 1];
  std::vector<std::int32_t> tets(end.back());
  std::vector<std::uint32_t> next(end.begin(), end.end() - 1);
  each([&](std::int32_t v, std::int32_t t) { tets[next[v]++] = t; });

  for (std::size_t before = held.size() + 1; held.size() < before;) {
    before = held.size();
    std::erase_if(held, [&](std::int32_t n) {
      poll();
      const std::int32_t v = n + kSuper;
      const Vec3 back = std::exchange(points_[v], positions[n]);
      for (std::uint32_t k = end[v]; k < end[v + 1]; ++k) {
        const auto& c = slots_[tets[k]].v;
        if (kernel::orientation(points_[c[0]], points_[c[1]], points_[c[2]], points_[c[3]]) > 0)
          continue;
        points_[v] = back;
        return false;
      }
      roles[v] = kMoved;
      return true;
    });
  }
}

void DelaunayMesh::flip_all(std::span<const std::int32_t> touched,
                            std::vector<std::int32_t>& unflipped, const Run& run) {
  // A facet between two touched tets is looked at from one side.
  scratch_.begin(slots_.size());
  const std::uint32_t mark = 2 * scratch_.epoch;
  for (const std::int32_t t : touched) scratch_.seen[t] = mark;
  auto stack = collect_in_blocks<std::int32_t>(
      touched.size(), kCheapBlock, run,
      [&](std::size_t begin, std::size_t end, std::vector<std::int32_t>& found) {
        run.poll();
        for (const std::int32_t t : touched.subspan(begin, end - begin)) {
          const auto& v = slots_[t].v;
          const kernel::SphereTest sphere(points_[v[0]], points_[v[1]], points_[v[2]],
                                          points_[v[3]]);
          for (int i = 0; i < 4; ++i) {
            const std::int32_t across = slots_[t].n[i];
            const bool mine = across < 0 || across >> 2 > t || scratch_.seen[across >> 2] != mark;
            if (!mine || across == -1) continue;
            const int side = sphere.side(opposite(across));
            if (side > 0 || (side == 0 && !is_delaunay(4 * t + i))) found.push_back(4 * t + i);
          }
        }
      });
  Polling poll(run);
  // Every flip lowers the lifted surface, so that this ends.
  while (!stack.empty()) {
    poll();
    const std::int32_t facet = stack.back();
    stack.pop_back();
    if (!flip(facet, stack)) unflipped.push_back(facet);
  }
}

bool DelaunayMesh::is_delaunay(std::int32_t facet) const {
  const std::int32_t across = slots_[facet >> 2].n[facet & 3];
  return across == -1 || !conflicts(facet >> 2, opposite(across));
}

bool DelaunayMesh::flip(std::int32_t facet, std::vector<std::int32_t>& stack) {
  const std::int32_t t = facet >> 2;
  const int i = facet & 3;
  const Slot& s = slots_[t];
  if (s.v[0] == kDead || is_delaunay(facet)) return true;
  if (s.n[i] < 0) {
    patch_too_small_ = true;
    return true;
  }
  const std::int32_t q = slots_[s.n[i] >> 2].v[s.n[i] & 3];
  int flat = -1, reflex = -1, bad = 0;
  for (const int c : kTetFacets[i]) {
    Vec3 corner[4] = {points_[s.v[0]], points_[s.v[1]], points_[s.v[2]], points_[s.v[3]]};
    corner[c] = points_[q];
    const int side = kernel::orientation(corner[0], corner[1], corner[2], corner[3]);
    if (side > 0) continue;
    ++bad;
    (side == 0 ? flat : reflex) = c;
  }
  if (bad > 1) return false;
  if (bad == 0) {
    flip_2_3(facet, stack);
    return true;
  }
  // The edge that the new one would pass: the facet's without corner c.
  const int c = flat >= 0 ? flat : reflex;
  std::int32_t edge[2]{-1, -1};
  int k = 0;
  for (const int other : kTetFacets[i])
    if (other != c) edge[k++] = s.v[other];
  return flip_3_2(t, edge[0], edge[1], stack) || (flat >= 0 && flip_4_4(facet, s.v[c], stack));
}

int DelaunayMesh::facet_opposite(std::int32_t tet, std::int32_t vertex) const {
  const auto& v = slots_[tet].v;
  for (int i = 0; i < 4; ++i)
    if (v[i] == vertex) return i;
  return -1;
}

bool DelaunayMesh::positive_with(std::int32_t tet, int corner, std::int32_t vertex) const {
  auto v = slots_[tet].v;
  v[corner] = vertex;
  return kernel::orientation(points_[v[0]], points_[v[1]], points_[v[2]], points_[v[3]]) > 0;
}

void DelaunayMesh::join(std::int32_t facet, std::int32_t other) {
  slots_[facet >> 2].n[facet & 3] = other;
  if (other >= 0) slots_[other >> 2].n[other & 3] = facet;
}

void DelaunayMesh::flip_2_3(std::int32_t facet, std::vector<std::int32_t>& stack) {
  const std::int32_t t = facet >> 2, u = slots_[t].n[facet & 3] >> 2;
  const int ip = facet & 3;
  const Slot old_t = slots_[t], old_u = slots_[u];
  const std::int32_t q = old_u.v[old_t.n[ip] & 3];
  // One new tet for each corner of the facet: t with that corner replaced by q.
  std::array<std::int32_t, 4> made{};
  int count = 0;
  for (const int c : kTetFacets[ip])
    made[c] = count == 0 ? t : count == 1 ? u : allocate(), ++count;
  for (const int c : kTetFacets[ip]) {
    Slot& s = slots_[made[c]];
    s.v = old_t.v;
    s.v[c] = q;
  }
  for (const int c : kTetFacets[ip]) {
    int in_u = 0;
    while (old_u.v[in_u] != old_t.v[c]) ++in_u;
    join(4 * made[c] + c, old_t.n[c]);
    join(4 * made[c] + ip, old_u.n[in_u]);
    for (const int r : kTetFacets[ip])
      if (r != c) slots_[made[c]].n[r] = 4 * made[r] + c;
    stack.push_back(4 * made[c] + c);
    stack.push_back(4 * made[c] + ip);
  }
  hint_ = t;
}

bool DelaunayMesh::flip_3_2(std::int32_t tet, std::int32_t a, std::int32_t b,
                            std::vector<std::int32_t>& stack) {
  const Slot t1 = slots_[tet];
  const int ia = facet_opposite(tet, a), ib = facet_opposite(tet, b);
  int ic = 0;
  while (ic == ia || ic == ib) ++ic;
  const int id = 6 - ia - ib - ic;
  if (t1.n[ic] < 0 || t1.n[id] < 0) return false;
  const std::int32_t t2 = t1.n[ic] >> 2, t3 = t1.n[id] >> 2;  // beyond (a, b, d) and (a, b, c)
  const Slot s2 = slots_[t2], s3 = slots_[t3];
  const std::int32_t e = s2.v[t1.n[ic] & 3];
  if (e != s3.v[t1.n[id] & 3]) return false;
  const int d_in_2 = facet_opposite(t2, t1.v[id]);
  if (s2.n[d_in_2] >> 2 != t3) return false;  // not the same tet round the edge
  if (!positive_with(tet, ib, e) || !positive_with(tet, ia, e)) return false;
  const auto across = [](const Slot& s, std::int32_t v) {
    int i = 0;
    while (s.v[i] != v) ++i;
    return s.n[i];
  };
  // N_a keeps a, in the slot of t1; N_b keeps b, in that of t2.
  const std::array<std::int32_t, 3> out_a{across(t1, b), across(s2, b), across(s3, b)};
  const std::array<std::int32_t, 3> out_b{across(t1, a), across(s2, a), across(s3, a)};
  slots_[tet].v = t1.v;
  slots_[tet].v[ib] = e;
  slots_[t2].v = t1.v;
  slots_[t2].v[ia] = e;
  slots_[t3].v[0] = kDead;
  free_.push_back(t3);
  // N_a: e stands in b's place; its facets opposite e, c, d come from t1, t2, t3.
  join(4 * tet + ib, out_a[0]);
  join(4 * tet + ic, out_a[1]);
  join(4 * tet + id, out_a[2]);
  join(4 * t2 + ia, out_b[0]);
  join(4 * t2 + ic, out_b[1]);
  join(4 * t2 + id, out_b[2]);
  slots_[tet].n[ia] = 4 * t2 + ib;
  slots_[t2].n[ib] = 4 * tet + ia;
  for (int k = 0; k < 4; ++k) {
    if (k != ia) stack.push_back(4 * tet + k);
    if (k != ib) stack.push_back(4 * t2 + k);
  }
  hint_ = tet;
  return true;
}

bool DelaunayMesh::flip_4_4(std::int32_t facet, std::int32_t s, std::vector<std::int32_t>& stack) {
  // t = (p, x, y, s) and u = (q, x, y, s) with p, q, x, y in one plane: the edge xy gives way to
  // pq, also on the other side of the plane, where two tets with a common corner w have to stand.
  const std::int32_t t = facet >> 2, u = slots_[t].n[facet & 3] >> 2;
  const std::int32_t beyond_t = slots_[t].n[facet_opposite(t, s)];
  const std::int32_t beyond_u = slots_[u].n[facet_opposite(u, s)];
  if (beyond_t < 0 || beyond_u < 0) return false;
  const std::int32_t t2 = beyond_t >> 2, u2 = beyond_u >> 2;
  const std::int32_t w = slots_[t2].v[beyond_t & 3];
  if (w != slots_[u2].v[beyond_u & 3] || t2 == u2) return false;
  const std::int32_t p = slots_[t].v[facet & 3];
  const std::int32_t q = slots_[u].v[slots_[t].n[facet & 3] & 3];
  std::int32_t x = -1, y = -1;
  for (const int c : kTetFacets[facet & 3])
    if (const std::int32_t v = slots_[t].v[c]; v != s) (x < 0 ? x : y) = v;
  const int p_in_2 = facet_opposite(t2, p);
  if (p_in_2 < 0 || slots_[t2].n[p_in_2] < 0 || slots_[t2].n[p_in_2] >> 2 != u2) return false;
  // All four tets of the result have to be positive.
  const auto turned = [&](std::int32_t tet, std::int32_t from, std::int32_t to) {
    return positive_with(tet, facet_opposite(tet, from), to);
  };
  if (!turned(t, x, q) || !turned(t, y, q) || !turned(t2, x, q) || !turned(t2, y, q)) return false;
  flip_2_3(facet, stack);
  // Among the three there is the flat tet (p, q, x, y) now, the third at the edge xy beside t2 and
  // u2.
  const bool done = flip_3_2(t2, x, y, stack);
  assert(done);
  return done;
}

}  // namespace remeshd
