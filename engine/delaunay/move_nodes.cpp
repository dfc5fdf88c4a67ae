// Moving nodes: Delaunay again by bistellar flips, and by removing and reinserting nodes where
// flips do not restore it.
#include <cassert>
#include <utility>

#include "engine/base/parallel.h"
#include "engine/delaunay/delaunay_mesh.h"
#include "engine/kernel/predicates.h"
#include "engine/mesh/grouping.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

namespace {

/// kHeld: moved back, because a tet was not positive. kUnflippable: at a facet that no flip made
/// Delaunay.
enum Role : std::uint8_t { kStill = 0, kMoved = 1, kHeld = 2, kUnflippable = 3 };

struct MotionLimits {
  double most_held = 0.25;          ///< share of the moved nodes; with more held, flips do not pay
  int tries = 2;                    ///< rounds; held nodes wait until others have made room
  std::size_t tets_per_try = 5000;  ///< least held nodes for another round: one per so many tets
};
constexpr MotionLimits kMotionLimits;

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
  std::vector<std::int32_t> again, going = moved;
  std::vector<FacetRef> unflipped;
  for (int k = 1;; ++k) {
    for (const std::int32_t n : going) {
      roles[n + kSuper] = kMoved;
      points_[n + kSuper] = positions[n];
    }
    const std::vector<std::int32_t> touched = tets_at_moved(roles, run);
    std::vector<std::int32_t> held = revert_inverted(touched, roles, old, run);
    retry(touched, positions, roles, held, run);
    if (k == 1 && static_cast<double>(held.size()) >
                      kMotionLimits.most_held * static_cast<double>(moved.size())) {
      for (const std::int32_t n : moved) points_[n + kSuper] = old[n + kSuper];
      return Moved::TooFar;
    }
    flip_all(touched, unflipped, run);
    for (const std::int32_t n : going)
      if (roles[n + kSuper] == kMoved) roles[n + kSuper] = kStill;
    if (k == kMotionLimits.tries || held.size() == going.size() ||
        held.size() * kMotionLimits.tets_per_try < slots_.size()) {
      again = std::move(held);
      break;
    }
    going = std::move(held);
  }
  // What flips could not restore: the corners of a facet that is not Delaunay are reinserted too.
  for (const FacetRef facet : unflipped) {
    if (!in_use(facet.tet()) || !across(facet).is_tet() || is_delaunay(facet)) continue;
    for (const int c : kTetFacets[facet.corner()]) {
      const std::int32_t v = slots_[facet.tet()].v[c];
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
  const auto tets_at_held = grouped<std::int32_t>(points_.size(), [&](const auto& visit) {
    for (const std::int32_t t : touched) {
      poll();
      for (const std::int32_t v : slots_[t].v)
        if (roles[v] == kHeld) visit(v, t);
    }
  });
  for (std::size_t before = held.size() + 1; held.size() < before;) {
    before = held.size();
    std::erase_if(held, [&](std::int32_t n) {
      poll();
      const std::int32_t v = n + kSuper;
      const Vec3 back = std::exchange(points_[v], positions[n]);
      for (const std::int32_t t : tets_at_held[v]) {
        const auto& c = slots_[t].v;
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

void DelaunayMesh::flip_all(std::span<const std::int32_t> touched, std::vector<FacetRef>& unflipped,
                            const Run& run) {
  // A facet between two touched tets is looked at from one side.
  scratch_.begin(slots_.size());
  const std::uint32_t mark = 2 * scratch_.epoch;
  for (const std::int32_t t : touched) scratch_.seen[t] = mark;
  auto stack = collect_in_blocks<FacetRef>(
      touched.size(), kCheapBlock, run,
      [&](std::size_t begin, std::size_t end, std::vector<FacetRef>& found) {
        run.poll();
        for (const std::int32_t t : touched.subspan(begin, end - begin)) {
          const auto& v = slots_[t].v;
          const kernel::SphereTest sphere(points_[v[0]], points_[v[1]], points_[v[2]],
                                          points_[v[3]]);
          for (int i = 0; i < 4; ++i) {
            const FacetRef other = slots_[t].n[i];
            const bool mine =
                !other.is_tet() || other.tet() > t || scratch_.seen[other.tet()] != mark;
            if (!mine || other.is_none()) continue;
            const int side = sphere.side(apex_position(other));
            if (side > 0 || (side == 0 && !is_delaunay({t, i}))) found.emplace_back(t, i);
          }
        }
      });
  Polling poll(run);
  // Every flip lowers the lifted surface, so that this ends.
  while (!stack.empty()) {
    poll();
    const FacetRef facet = stack.back();
    stack.pop_back();
    if (!flip(facet, stack)) unflipped.push_back(facet);
  }
}

bool DelaunayMesh::is_delaunay(FacetRef facet) const {
  const FacetRef other = across(facet);
  return other.is_none() || !conflicts(facet.tet(), apex_position(other));
}

bool DelaunayMesh::flip(FacetRef facet, std::vector<FacetRef>& stack) {
  const std::int32_t t = facet.tet();
  const int i = facet.corner();
  const Slot& s = slots_[t];
  if (s.v[0] == kDead || is_delaunay(facet)) return true;
  if (!s.n[i].is_tet()) {
    patch_too_small_ = true;
    return true;
  }
  const std::int32_t q = apex(s.n[i]);
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
  // The edge of the facet that the line between the two apexes meets or passes by outside: the one
  // without corner c.
  const int c = flat >= 0 ? flat : reflex;
  std::int32_t edge[2]{-1, -1};
  int k = 0;
  for (const int other : kTetFacets[i])
    if (other != c) edge[k++] = s.v[other];
  return flip_3_2(t, edge[0], edge[1], stack) || (flat >= 0 && flip_4_4(facet, s.v[c], stack));
}

bool DelaunayMesh::positive_with(std::int32_t tet, int corner, std::int32_t vertex) const {
  auto v = slots_[tet].v;
  v[corner] = vertex;
  return kernel::orientation(points_[v[0]], points_[v[1]], points_[v[2]], points_[v[3]]) > 0;
}

void DelaunayMesh::flip_2_3(FacetRef facet, std::vector<FacetRef>& stack) {
  const std::int32_t t = facet.tet(), u = across(facet).tet(), q = apex(across(facet));
  const int ip = facet.corner();
  const Slot old_t = slots_[t], old_u = slots_[u];
  // One new tet for each corner of the facet: t with that corner replaced by q.
  std::array<std::int32_t, 4> made{};
  int count = 0;
  for (const int c : kTetFacets[ip])
    made[c] = count == 0 ? t : count == 1 ? u : allocate(), ++count;
  for (const int c : kTetFacets[ip]) {
    Slot& s = slots_[made[c]];
    s.v = old_t.v;
    s.v[c] = q;
    join({made[c], c}, old_t.n[c]);
    join({made[c], ip}, old_u.across(old_t.v[c]));
    for (const int r : kTetFacets[ip])
      if (r != c) s.n[r] = {made[r], c};
    stack.emplace_back(made[c], c);
    stack.emplace_back(made[c], ip);
  }
  hint_ = t;
}

bool DelaunayMesh::flip_3_2(std::int32_t tet, std::int32_t a, std::int32_t b,
                            std::vector<FacetRef>& stack) {
  const Slot t1 = slots_[tet];
  const int ia = t1.corner_of(a), ib = t1.corner_of(b);
  int ic = 0;
  while (ic == ia || ic == ib) ++ic;
  const int id = 6 - ia - ib - ic;
  if (!t1.n[ic].is_tet() || !t1.n[id].is_tet()) return false;
  const std::int32_t t2 = t1.n[ic].tet(), t3 = t1.n[id].tet();  // beyond (a, b, d) and (a, b, c)
  const Slot s2 = slots_[t2], s3 = slots_[t3];
  const std::int32_t e = apex(t1.n[ic]);
  if (e != apex(t1.n[id])) return false;
  if (s2.across(t1.v[id]).tet() != t3) return false;  // more than three tets round the edge
  if (!positive_with(tet, ib, e) || !positive_with(tet, ia, e)) return false;
  // The new tet with a takes the slot of t1, that with b the slot of t2.
  slots_[tet].v = t1.v;
  slots_[tet].v[ib] = e;
  slots_[t2].v = t1.v;
  slots_[t2].v[ia] = e;
  release(t3);
  // In the tet with a, e is in the place of b; its facets opposite e, c, d come from t1, t2, t3.
  join({tet, ib}, t1.across(b));
  join({tet, ic}, s2.across(b));
  join({tet, id}, s3.across(b));
  join({t2, ia}, t1.across(a));
  join({t2, ic}, s2.across(a));
  join({t2, id}, s3.across(a));
  join({tet, ia}, {t2, ib});
  for (int k = 0; k < 4; ++k) {
    if (k != ia) stack.emplace_back(tet, k);
    if (k != ib) stack.emplace_back(t2, k);
  }
  hint_ = tet;
  return true;
}

bool DelaunayMesh::flip_4_4(FacetRef facet, std::int32_t s, std::vector<FacetRef>& stack) {
  // t = (p, x, y, s) and u = (q, x, y, s) with p, q, x, y in one plane: the edge xy gives way to
  // pq, also on the other side of the plane, where two tets with a common corner w have to stand.
  const std::int32_t t = facet.tet(), u = across(facet).tet();
  const FacetRef beyond_t = slots_[t].across(s), beyond_u = slots_[u].across(s);
  if (!beyond_t.is_tet() || !beyond_u.is_tet()) return false;
  const std::int32_t t2 = beyond_t.tet(), u2 = beyond_u.tet();
  if (apex(beyond_t) != apex(beyond_u) || t2 == u2) return false;
  [[maybe_unused]] const std::int32_t p = apex(facet);
  const std::int32_t q = apex(across(facet));
  std::int32_t x = -1, y = -1;
  for (const int c : kTetFacets[facet.corner()])
    if (const std::int32_t v = slots_[t].v[c]; v != s) (x < 0 ? x : y) = v;
  assert(slots_[t2].n[slots_[t2].corner_of(p)].tet() == u2);  // both have the facet (x, y, w)
  // All four tets of the result have to be positive.
  const auto turned = [&](std::int32_t tet, std::int32_t from, std::int32_t to) {
    return positive_with(tet, slots_[tet].corner_of(from), to);
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
