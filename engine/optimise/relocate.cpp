#include "engine/optimise/relocate.h"

#include <utility>

#include "engine/base/parallel.h"
#include "engine/mesh/quality.h"

namespace remeshd {

std::vector<std::uint8_t> relocated(const NodeSet& nodes) {
  std::vector<std::uint8_t> moves(nodes.positions.size());
  for (std::size_t n = 0; n < moves.size(); ++n)
    moves[n] = nodes.is_free(n) && nodes.supports[n].kind == Support::Kind::Interior ? 1 : 0;
  return moves;
}

namespace {

/// Sums over the tets of a node; it moves by moment / mass.
struct MassMoment {
  Vec3 moment;
  double mass = 0;
};

/// Adds a tet, its volume times `weight`, to the sums of those of its nodes with a 1 in `at`.
void add(const NodeSet& nodes, const Tet& t, const std::vector<std::uint8_t>& at, double weight,
         std::vector<MassMoment>& sums) {
  const Vec3 &a = nodes.positions[t[0]], &b = nodes.positions[t[1]], &c = nodes.positions[t[2]],
             &d = nodes.positions[t[3]];
  const Vec3 ab = b - a, ac = c - a, ad = d - a;
  const Vec3 nc = cross(ab, ac), nd = cross(ac, ad), nb = cross(ad, ab);
  const double six_volume = dot(nc, ad);
  // Volume times circumcentre, relative to a; needs no division, so that slivers do no harm.
  const Vec3 m = (norm2(ad) * nc + norm2(ac) * nb + norm2(ab) * nd) / 12.0;
  for (const std::int32_t n : t) {
    if (!at[n]) continue;
    sums[n].moment += weight * (m + (six_volume / 6) * (a - nodes.positions[n]));
    sums[n].mass += weight * (six_volume / 6);
  }
}

/// The density of nodes asked for in a tet, relative to that at the base length: (base / h)^3,
/// where h is the mean edge length at its nodes.
double density(const Tet& t, const NodeLengths& lengths) {
  if (lengths.even()) return 1;
  const double of_four = lengths[t[0]] + lengths[t[1]] + lengths[t[2]] + lengths[t[3]];
  const double coarser = 4 * lengths.base() / of_four;
  return coarser * coarser * coarser;
}

bool any(const std::vector<std::uint8_t>& at, const Tet& t) {
  return (at[t[0]] | at[t[1]] | at[t[2]] | at[t[3]]) != 0;
}

}  // namespace

void relocate(NodeSet& nodes, std::span<const Tet> tets, const InsideTest& inside,
              const NodeLengths& lengths, const Run& run) {
  const std::vector<std::uint8_t> moves = relocated(nodes);
  std::vector<MassMoment> sums(moves.size());
  Polling poll(run);
  for (const Tet& t : tets) {
    poll();
    if (any(moves, t)) add(nodes, t, moves, density(t, lengths), sums);
  }
  std::vector<Vec3> to = nodes.positions;
  std::vector<std::uint8_t> stuck(moves.size(), 0);
  const auto all_stuck = collect_in_blocks<std::int32_t>(
      moves.size(), kDearBlock, run,
      [&](std::size_t begin, std::size_t end, std::vector<std::int32_t>& found) {
        run.poll();
        for (std::size_t n = begin; n < end; ++n) {
          if (!moves[n] || sums[n].mass <= 0) continue;
          const Vec3 p = nodes.positions[n] + sums[n].moment / sums[n].mass;
          if (inside(p)) {
            to[n] = p;
            continue;
          }
          stuck[n] = 1;
          sums[n] = {};
          found.push_back(static_cast<std::int32_t>(n));
        }
      });
  if (!all_stuck.empty()) {
    for (const Tet& t : tets)
      if (any(stuck, t) && inside(centroid(nodes.positions, t)))
        add(nodes, t, stuck, density(t, lengths), sums);
    for (const std::int32_t n : all_stuck) {
      if (sums[n].mass <= 0) continue;
      const Vec3 p = nodes.positions[n] + sums[n].moment / sums[n].mass;
      if (inside(p)) to[n] = p;
    }
  }
  nodes.positions = std::move(to);
}

double mean_quality(const NodeSet& nodes, std::span<const Tet> tets, const Run& run) {
  const std::vector<std::uint8_t> moves = relocated(nodes);
  double quality = 0;
  std::size_t counted = 0;
  Polling poll(run);
  for (const Tet& t : tets) {
    poll();
    if (!any(moves, t)) continue;
    quality += volume_length(nodes.positions, t);
    ++counted;
  }
  return counted ? quality / static_cast<double>(counted) : 0;
}

}  // namespace remeshd
