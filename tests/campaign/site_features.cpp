#include "tests/campaign/site_features.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace remeshd::campaign {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLeast = 1.4;  // of a feature and of a wall, in l

/// What may stand on a site: sizes in the model's unit.
struct Place {
  Transform frame;
  double radius, depth, l;
};

using Ids = std::vector<std::string>;

double between(Draft& d, double lo, double hi) { return hi > lo ? d.random.uniform(lo, hi) : lo; }

/// A boss's height, and how deep its foot stands in the material: now and then not at all, so that
/// the foot coincides with the face.
struct Foot {
  double height, sunk;
};
Foot foot(Draft& d, const Place& p) {
  const double sunk = p.depth > 2 * p.l && d.chance(0.5) ? between(d, 0.5, 1.5) * p.l : 0;
  return {sunk + between(d, kLeast, 6) * p.l, sunk};
}

Ids round_boss(Draft& d, const Place& p) {
  const Foot f = foot(d, p);
  const double r = between(d, 0.8 * kLeast * p.l, p.radius);
  const Transform at = shifted(p.frame, 0, 0, -f.sunk);
  if (d.chance(0.3) && r > 2 * p.l) {
    const double top = between(d, 0.6, 0.9) * r;
    return {d.add("cone", Nature::Additive, at,
                  {{"radius_bottom", r}, {"radius_top", top}, {"height", f.height}})};
  }
  return {d.add("cylinder", Nature::Additive, at, {{"radius", r}, {"height", f.height}})};
}

Ids square_boss(Draft& d, const Place& p) {
  const Foot f = foot(d, p);
  const double half = p.radius * std::sqrt(0.5);
  const Transform at =
      turned(shifted(p.frame, 0, 0, -f.sunk), 2, d.chance(0.5) ? 0 : d.random.uniform(0, kPi));
  const double a = between(d, kLeast * p.l, 2 * half), b = between(d, kLeast * p.l, 2 * half);
  return {d.add("block", Nature::Additive, at, {{"dx", a}, {"dy", b}, {"dz", f.height}})};
}

Ids slot_boss(Draft& d, const Place& p) {
  const Foot f = foot(d, p);
  const double width = between(d, kLeast * p.l, 1.2 * p.radius);
  const double length = between(d, width + 1.2 * p.l, 2 * p.radius);
  if (length > 2 * p.radius) return round_boss(d, p);
  const Transform at = turned(shifted(p.frame, 0, 0, -f.sunk), 2, d.random.uniform(0, kPi));
  return {d.add("slot", Nature::Additive, at,
                {{"length", length}, {"width", width}, {"height", f.height}})};
}

Ids prism_boss(Draft& d, const Place& p) {
  const Foot f = foot(d, p);
  const Transform at = shifted(p.frame, 0, 0, -f.sunk);
  if (d.chance(0.4)) {  // a half disc
    const double r = between(d, 1.5 * p.l, p.radius);
    const std::vector<ProfileEntry> profile{
        {-r, 0.0, {}}, {r, 0.0, {}}, {-r, 0.0, std::array<Scalar, 2>{0.0, r}}};
    return {d.add_outline("prism", Nature::Additive, at, profile, {{"height", f.height}})};
  }
  const int n = 3 + static_cast<int>(d.random.below(4));
  const double least = 0.5 * kLeast * p.l / std::sin(kPi / n);
  return {d.add_outline("prism", Nature::Additive, at, polygon(n, between(d, least, p.radius)),
                        {{"height", f.height}})};
}

Ids dome(Draft& d, const Place& p) {
  const double r = between(d, kLeast * p.l, p.radius);
  return {d.add("sphere", Nature::Additive, shifted(p.frame, 0, 0, -r * d.random.uniform(0, 0.5)),
                {{"radius", r}})};
}

Ids bead(Draft& d, const Place& p) {
  const double minor = between(d, 1.2 * p.l, 0.45 * (p.radius - 0.6 * p.l));
  const double major = p.radius - minor;
  if (major < minor + 0.8 * p.l) return dome(d, p);
  return {d.add("torus", Nature::Additive, p.frame,
                {{"major_radius", major}, {"minor_radius", minor}})};
}

Ids turned_boss(Draft& d, const Place& p) {
  const double r = p.radius, step = between(d, 1.2 * p.l, 0.4 * r), h = between(d, kLeast, 4) * p.l;
  if (r - step < 1.2 * p.l) return round_boss(d, p);
  return {d.add_outline(
      "revolution", Nature::Additive, p.frame,
      outline({{0, 0}, {r, 0}, {r, h}, {r - step, h}, {r - step, 2 * h}, {0, 2 * h}}), {})};
}

/// How far a hole reaches down; where through, now and then flush with the far face.
double reach(Draft& d, const Place& p) {
  if (p.depth > (2 * kLeast + 0.2) * p.l && d.chance(0.5))
    return between(d, kLeast * p.l, p.depth - kLeast * p.l);
  return d.chance(0.5) ? p.depth : p.depth + p.l;
}

Ids round_hole(Draft& d, const Place& p) {
  const double deep = reach(d, p), over = d.chance(0.5) ? 0 : p.l;
  const double r = between(d, 0.6 * kLeast * p.l, p.radius);
  const Transform at = shifted(p.frame, 0, 0, -deep);
  if (d.chance(0.2) && r > 2.5 * p.l)
    return {d.add("cone", Nature::Subtractive, at,
                  {{"radius_bottom", 0.6 * r}, {"radius_top", r}, {"height", deep}})};
  return {d.add("cylinder", Nature::Subtractive, at, {{"radius", r}, {"height", deep + over}})};
}

Ids pocket(Draft& d, const Place& p) {
  const double deep = reach(d, p), over = d.chance(0.5) ? 0 : p.l;
  const Transform at = turned(shifted(p.frame, 0, 0, -deep), 2, d.random.uniform(0, kPi));
  const double half = p.radius * std::sqrt(0.5);
  const double a = between(d, kLeast * p.l, 2 * half), b = between(d, kLeast * p.l, 2 * half);
  switch (d.random.below(3)) {
    case 0:
      return {d.add("block", Nature::Subtractive, at, {{"dx", a}, {"dy", b}, {"dz", deep + over}})};
    case 1:
      if (2 * p.radius > b + 1.5 * p.l)
        return {d.add("slot", Nature::Subtractive, at,
                      {{"length", between(d, b + 1.3 * p.l, 2 * p.radius)},
                       {"width", b},
                       {"height", deep + over}})};
      [[fallthrough]];
    default: {
      const int n = 3 + static_cast<int>(d.random.below(4));
      const double least = 0.5 * kLeast * p.l / std::sin(kPi / n);
      return {d.add_outline("prism", Nature::Subtractive, at,
                            polygon(n, between(d, least, p.radius)), {{"height", deep + over}})};
    }
  }
}

Ids dimple(Draft& d, const Place& p) {
  const double r = std::min(between(d, kLeast * p.l, p.radius), p.depth - kLeast * p.l);
  if (r < p.l) return round_hole(d, p);
  if (d.chance(0.4)) {
    const double minor = std::min(0.4 * p.radius, r), major = p.radius - minor;
    if (minor > 1.2 * p.l && major > minor + 0.8 * p.l)
      return {d.add("torus", Nature::Subtractive, p.frame,
                    {{"major_radius", major}, {"minor_radius", minor}})};
  }
  return {d.add("sphere", Nature::Subtractive, shifted(p.frame, 0, 0, 0.3 * r), {{"radius", r}})};
}

/// A boss with a hole down its axis.
Ids bushing(Draft& d, const Place& p) {
  if (p.radius < 2.6 * p.l) return round_boss(d, p);
  const double r = between(d, 2.5 * p.l, p.radius);
  const double bore = between(d, 0.8 * p.l, r - kLeast * p.l);
  const Foot f = foot(d, p);
  const double deep = reach(d, p);
  return {d.add("cylinder", Nature::Additive, shifted(p.frame, 0, 0, -f.sunk),
                {{"radius", r}, {"height", f.height}}),
          d.add("cylinder", Nature::Subtractive, shifted(p.frame, 0, 0, -deep),
                {{"radius", bore}, {"height", deep + f.height - f.sunk + p.l}})};
}

/// Two coaxial cylinders, now and then of the same radius: then their walls coincide.
Ids stacked(Draft& d, const Place& p) {
  const double r = between(d, kLeast * p.l, p.radius), h = between(d, kLeast, 3) * p.l;
  const bool same = d.chance(0.5) || r < 2.8 * p.l;
  return {d.add("cylinder", Nature::Additive, p.frame, {{"radius", r}, {"height", h}}),
          d.add("cylinder", Nature::Additive, shifted(p.frame, 0, 0, h),
                {{"radius", same ? r : r - kLeast * p.l}, {"height", h}})};
}

/// A boss that leans by up to 35 degrees, its foot well inside.
Ids leaning(Draft& d, const Place& p) {
  if (p.depth < 2.5 * p.l || p.radius < 2 * p.l) return square_boss(d, p);
  const double lean = d.random.uniform(0.05, 0.6);
  const double sunk = 1.2 * p.l, r = between(d, p.l, 0.6 * p.radius);
  const Transform at =
      shifted(turned(turned(p.frame, 2, d.random.uniform(0, 2 * kPi)), 0, lean), 0, 0, -sunk);
  const double h = sunk + r + between(d, kLeast, 4) * p.l;
  if (d.chance(0.5))
    return {d.add("cylinder", Nature::Additive, at, {{"radius", r}, {"height", h}})};
  return {d.add("block", Nature::Additive, at, {{"dx", 1.4 * r}, {"dy", 1.4 * r}, {"dz", h}})};
}

}  // namespace

std::vector<std::size_t> free_sites(const Draft& d) {
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < d.sites.size(); ++k)
    if (d.sites[k].features.empty()) result.push_back(k);
  return result;
}

std::vector<std::string> add_on_site(Draft& d, std::size_t index) {
  using Make = Ids (*)(Draft&, const Place&);
  static constexpr std::array<Make, 10> kBosses{round_boss, square_boss, slot_boss,   prism_boss,
                                                dome,       bead,        turned_boss, bushing,
                                                stacked,    leaning};
  static constexpr std::array<Make, 4> kHoles{round_hole, round_hole, pocket, dimple};
  const Site& site = d.sites[index];
  if (site.radius < d.length) return {};
  const Place place{site.frame, site.radius, site.depth, d.length};
  const bool hole = site.depth > 1.3 * kLeast * d.length && d.chance(0.5);
  Ids ids = hole ? kHoles[d.random.below(kHoles.size())](d, place)
                 : kBosses[d.random.below(kBosses.size())](d, place);
  d.sites[index].features = ids;
  return ids;
}

}  // namespace remeshd::campaign
