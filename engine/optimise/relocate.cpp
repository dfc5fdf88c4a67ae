#include "engine/optimise/relocate.h"

#include <vector>

#include "engine/mesh/quality.h"

namespace remeshd {

double relocate(NodeSet& nodes, std::span<const Tet> tets, const InsideTest& inside,
                const Run& run) {
  std::vector<Vec3> moment(nodes.positions.size());
  std::vector<double> volume(nodes.positions.size(), 0.0);
  double quality = 0;
  std::size_t counted = 0;
  const auto moves = [&](std::int32_t n) {
    return nodes.free[n] && nodes.supports[n].kind == Support::Kind::Interior;
  };
  Polling poll(run);
  for (const Tet& t : tets) {
    poll();
    if (!moves(t[0]) && !moves(t[1]) && !moves(t[2]) && !moves(t[3])) continue;
    const Vec3 &a = nodes.positions[t[0]], &b = nodes.positions[t[1]], &c = nodes.positions[t[2]],
               &d = nodes.positions[t[3]];
    const Vec3 ab = b - a, ac = c - a, ad = d - a;
    const Vec3 nc = cross(ab, ac), nd = cross(ac, ad), nb = cross(ad, ab);
    const double six_volume = dot(nc, ad);
    // Volume times circumcentre, relative to a; needs no division, so that slivers do no harm.
    const Vec3 m = (norm2(ad) * nc + norm2(ac) * nb + norm2(ab) * nd) / 12.0;
    for (const std::int32_t n : t) {
      if (!moves(n)) continue;
      moment[n] += m + (six_volume / 6) * (a - nodes.positions[n]);
      volume[n] += six_volume / 6;
    }
    quality += volume_length(a, b, c, d);
    ++counted;
  }
  for (std::int32_t n = 0; n < nodes.size(); ++n) {
    if (!moves(n) || volume[n] <= 0) continue;
    const Vec3 p = nodes.positions[n] + moment[n] / volume[n];
    if (inside(p)) nodes.positions[n] = p;
  }
  return counted ? quality / static_cast<double>(counted) : 0;
}

}  // namespace remeshd
