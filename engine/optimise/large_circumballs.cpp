#include "engine/optimise/large_circumballs.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "engine/mesh/circumball.h"

namespace remeshd {

namespace {

constexpr double kFlat = 1e-9;  // x least edge length^3: six times the volume of a flat tet

struct Circumball {
  double radius2;
  Vec3 centre;
};

std::optional<Circumball> ball_of(const std::vector<Vec3>& p, const Tet& t, double flat) {
  const Vec3 &o = p[t[0]], a = p[t[1]] - o, b = p[t[2]] - o, c = p[t[3]] - o;
  if (dot(a, cross(b, c)) <= flat) return std::nullopt;
  const Vec3 to = to_circumcentre(a, b, c);
  return Circumball{norm2(to), o + to};
}

}  // namespace

std::int32_t insert_at_circumcentres(NodeSet& nodes, std::span<const Tet> tets,
                                     const InsideTest& inside, const SizeField& sizes,
                                     double largest) {
  const auto least2 = [&](const Vec3& p) {
    const double l = largest * sizes(p);
    return l * l;
  };
  const double flat = sizes.least() * sizes.least() * sizes.least();
  std::vector<Circumball> large_circumballs;
  for (const Tet& t : tets) {
    if (!std::ranges::all_of(
            t, [&](std::int32_t n) { return nodes.supports[n].kind == Support::Kind::Interior; }))
      continue;
    const std::optional<Circumball> ball = ball_of(nodes.positions, t, kFlat * flat);
    if (ball && ball->radius2 > least2(ball->centre) && inside(ball->centre))
      large_circumballs.push_back(*ball);
  }
  std::ranges::stable_sort(large_circumballs, std::ranges::greater(), &Circumball::radius2);
  const std::int32_t first = nodes.size();
  for (const Circumball& v : large_circumballs) {
    const double around2 = least2(v.centre);
    const auto near = [&](const Vec3& p) { return norm2(p - v.centre) <= around2; };
    if (std::none_of(nodes.positions.begin() + first, nodes.positions.end(), near))
      nodes.add_new(v.centre);
  }
  return nodes.size() - first;
}

}  // namespace remeshd
