#include "tests/campaign/mean_features.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "tests/campaign/any_feature.h"

namespace remeshd::campaign {
namespace {

using std::numbers::pi;
constexpr Nature kAdd = Nature::Additive;
constexpr Nature kCut = Nature::Subtractive;

using Ids = std::vector<std::string>;

/// Where it is to be: radius of a boss that carries it, material below, and l.
struct Place {
  Transform frame;
  double r, depth, l;
};
using Make = Ids (*)(Draft&, const Place&);

Transform lying(const Transform& frame) { return turned(frame, 1, pi / 2); }  // z along x

// --- Tangent contacts -----------------------------------------------------------------------

Ids cylinder_inside_cylinder(Draft& d, const Place& p) {
  const double small = p.r * d.random.uniform(0.25, 0.6), h = p.r * d.random.uniform(0.4, 1.2);
  return {d.add("cylinder", kAdd, p.frame, {{"radius", p.r}, {"height", h}}),
          d.add("cylinder", kAdd, shifted(p.frame, p.r - small, 0, 0),
                {{"radius", small}, {"height", h + d.random.uniform(0.5, 2) * p.l}})};
}

Ids cylinder_in_square(Draft& d, const Place& p) {
  const double h = p.r * d.random.uniform(0.4, 1);
  return {d.add("block", kAdd, p.frame, {{"dx", 2 * p.r}, {"dy", 2 * p.r}, {"dz", h}}),
          d.add("cylinder", kAdd, p.frame, {{"radius", p.r}, {"height", 1.5 * h}})};
}

Ids round_end(Draft& d, const Place& p) {
  const double b = p.r * d.random.uniform(0.6, 1.2), h = p.r * d.random.uniform(0.4, 1);
  return {d.add("block", kAdd, p.frame, {{"dx", p.r}, {"dy", b}, {"dz", h}}),
          d.add("cylinder", kAdd, shifted(p.frame, 0.5 * p.r, 0, 0),
                {{"radius", 0.5 * b}, {"height", d.chance(0.5) ? h : 0.6 * h}})};
}

Ids domed_pin(Draft& d, const Place& p) {
  const double r = p.r * d.random.uniform(0.4, 1), h = p.r * d.random.uniform(0.4, 1);
  return {d.add("cylinder", kAdd, p.frame, {{"radius", r}, {"height", h}}),
          d.add("sphere", kAdd, shifted(p.frame, 0, 0, h), {{"radius", r}})};
}

Ids crossing_holes(Draft& d, const Place& p) {
  const double a = 2 * p.r, r = a * d.random.uniform(0.15, 0.35);
  const Transform middle = shifted(p.frame, 0, 0, 0.5 * a);
  return {
      d.add("block", kAdd, p.frame, {{"dx", a}, {"dy", a}, {"dz", a}}),
      d.add("cylinder", kCut, shifted(lying(middle), 0, 0, -a), {{"radius", r}, {"height", 2 * a}}),
      d.add("cylinder", kCut, shifted(lying(turned(middle, 2, pi / 2)), 0, 0, -a),
            {{"radius", r}, {"height", 2 * a}})};
}

Ids hole_in_pocket(Draft& d, const Place& p) {
  const double w = p.r * d.random.uniform(0.6, 1.2), h = p.r;
  return {d.add("block", kAdd, p.frame, {{"dx", 3 * p.r}, {"dy", 2 * p.r}, {"dz", h}}),
          d.add("block", kCut, shifted(p.frame, 0, 0, 0.6 * h),
                {{"dx", 2 * p.r}, {"dy", w}, {"dz", h}}),
          d.add("cylinder", kCut, shifted(p.frame, 0.3 * p.r, 0, 0.3 * h),
                {{"radius", 0.5 * w}, {"height", h}})};
}

Ids ball_under_face(Draft& d, const Place& p) {
  const double h = p.r * d.random.uniform(0.8, 1.2), r = 0.5 * h * d.random.uniform(0.4, 0.9);
  return {d.add("block", kAdd, p.frame, {{"dx", 2 * p.r}, {"dy", 2 * p.r}, {"dz", h}}),
          d.add("sphere", kAdd, shifted(p.frame, 0, 0, h - r), {{"radius", r}})};
}

Ids bead_on_rim(Draft& d, const Place& p) {
  const double minor = p.r * d.random.uniform(0.15, 0.35), h = p.r * d.random.uniform(0.3, 1);
  return {d.add("cylinder", kAdd, p.frame, {{"radius", p.r}, {"height", h}}),
          d.add("torus", kAdd, shifted(p.frame, 0, 0, h),
                {{"major_radius", p.r - minor}, {"minor_radius", minor}})};
}

Ids hole_beside_pin(Draft& d, const Place& p) {
  const double pin = p.r * d.random.uniform(0.2, 0.5), hole = p.r * d.random.uniform(0.2, 0.5);
  const double h = 0.5 * p.r;
  return {d.add("block", kAdd, p.frame, {{"dx", 3 * p.r}, {"dy", 2 * p.r}, {"dz", h}}),
          d.add("cylinder", kAdd, shifted(p.frame, -pin, 0, h),
                {{"radius", pin}, {"height", d.random.uniform(0.3, 1) * p.r}}),
          d.add("cylinder", kCut, shifted(p.frame, hole, 0, 0.4 * h),
                {{"radius", hole}, {"height", h}})};
}

Ids rod_under_face(Draft& d, const Place& p) {
  const double h = p.r, r = h * d.random.uniform(0.2, 0.45);
  return {d.add("block", kAdd, p.frame, {{"dx", p.r}, {"dy", 2 * p.r}, {"dz", h}}),
          d.add("cylinder", kAdd, shifted(lying(shifted(p.frame, 0, 0, h - r)), 0, 0, -p.r),
                {{"radius", r}, {"height", 2 * p.r}})};
}

// --- Coincident faces -----------------------------------------------------------------------

Ids same_footprint(Draft& d, const Place& p) {
  const double h = p.r * d.random.uniform(0.3, 0.8), overlap = d.chance(0.5) ? 0 : 0.4 * h;
  return {d.add("block", kAdd, p.frame, {{"dx", p.r}, {"dy", 1.3 * p.r}, {"dz", h}}),
          d.add("block", kAdd, shifted(p.frame, 0, 0, h - overlap),
                {{"dx", p.r}, {"dy", d.chance(0.5) ? 1.3 * p.r : 0.7 * p.r}, {"dz", h}})};
}

Ids same_radius(Draft& d, const Place& p) {
  const double h = p.r * d.random.uniform(0.4, 1), turn = d.random.uniform(0, pi);
  return {d.add("cylinder", kAdd, p.frame, {{"radius", p.r}, {"height", h}}),
          d.add("cylinder", kAdd, turned(shifted(p.frame, 0, 0, 0.5 * h), 2, turn),
                {{"radius", p.r}, {"height", h}})};
}

Ids plugged_hole(Draft& d, const Place& p) {
  const double r = p.r * d.random.uniform(0.3, 0.7), h = p.r;
  return {d.add("cylinder", kAdd, p.frame, {{"radius", p.r}, {"height", h}}),
          d.add("cylinder", kCut, p.frame, {{"radius", r}, {"height", h}}),
          d.add("cylinder", kAdd, p.frame,
                {{"radius", r}, {"height", h * d.random.uniform(0.3, 1.3)}})};
}

Ids flush_cut(Draft& d, const Place& p) {
  const double h = p.r;
  return {d.add("block", kAdd, p.frame, {{"dx", 2 * p.r}, {"dy", 2 * p.r}, {"dz", h}}),
          d.add("block", kCut, shifted(p.frame, 0.5 * p.r, 0, 0.4 * h),
                {{"dx", p.r}, {"dy", d.chance(0.5) ? 2 * p.r : p.r}, {"dz", 0.6 * h}})};
}

Ids twice_the_same(Draft& d, const Place& p) {
  const double h = p.r * d.random.uniform(0.4, 1);
  const std::vector<ProfileEntry> profile = polygon(3 + static_cast<int>(d.random.below(5)), p.r);
  return {d.add_outline("prism", kAdd, p.frame, profile, {{"height", h}}),
          d.add_outline("prism", kAdd, p.frame, profile, {{"height", h}})};
}

Ids same_cone(Draft& d, const Place& p) {
  const double h = p.r * d.random.uniform(0.5, 1), middle = 0.8 * p.r, top = 0.6 * p.r;
  return {
      d.add("cone", kAdd, p.frame, {{"radius_bottom", p.r}, {"radius_top", middle}, {"height", h}}),
      d.add("cone", kAdd, shifted(p.frame, 0, 0, h),
            {{"radius_bottom", middle}, {"radius_top", top}, {"height", h}})};
}

Ids side_by_side(Draft& d, const Place& p) {
  const double a = p.r * d.random.uniform(0.5, 1), b = p.r * d.random.uniform(0.5, 1), h = p.r;
  const Transform at = turned(p.frame, 2, d.random.uniform(0, pi));
  return {d.add("block", kAdd, at, {{"dx", a}, {"dy", a}, {"dz", h}}),
          d.add("block", kAdd, shifted(at, 0.5 * (a + b), 0, 0),
                {{"dx", b}, {"dy", a}, {"dz", d.chance(0.5) ? h : 0.5 * h}})};
}

// --- Wedges -----------------------------------------------------------------------------------

double sharp(Draft& d) { return d.random.uniform(8, 30) * pi / 180; }

Ids sharp_prism(Draft& d, const Place& p) {
  const double half = std::tan(0.5 * sharp(d));
  const double a = 2 * p.r, h = p.r * d.random.uniform(0.4, 1);
  return {d.add_outline("prism", kAdd, turned(p.frame, 2, d.random.uniform(0, pi)),
                        outline({{-p.r, 0}, {p.r, -a * half}, {p.r, a * half}}), {{"height", h}})};
}

Ids ramp(Draft& d, const Place& p) {
  // A block's top comes out of the face at a flat angle.
  const Transform at = turned(shifted(p.frame, 0, 0, -0.3 * p.r), 1, sharp(d));
  return {d.add("block", kAdd, at, {{"dx", 1.6 * p.r}, {"dy", p.r}, {"dz", 0.5 * p.r}})};
}

Ids groove(Draft& d, const Place& p) {
  const double h = p.r, half = std::tan(0.5 * sharp(d));
  const Transform across = turned(shifted(p.frame, 0, -2 * p.r, h), 0, -pi / 2);
  // Local y points down there: a V-shaped groove from the top.
  return {d.add("block", kAdd, p.frame, {{"dx", 2 * p.r}, {"dy", 2 * p.r}, {"dz", h}}),
          d.add_outline("prism", kCut, across,
                        outline({{0, 0.6 * h}, {-h * half, -0.4 * h}, {h * half, -0.4 * h}}),
                        {{"height", 4 * p.r}})};
}

Ids pie(Draft& d, const Place& p) {
  const double h = p.r * d.random.uniform(0.4, 1), angle = sharp(d) * 180 / pi;
  return {d.add_outline("revolution", kAdd, p.frame, outline({{0, 0}, {p.r, 0}, {p.r, h}, {0, h}}),
                        {{"angle", d.chance(0.5) ? angle : 360 - angle}})};
}

Ids flat_cone(Draft& d, const Place& p) {
  const double h = p.r * std::tan(sharp(d));
  const double disc = 0.3 * p.r;
  // On a neck, so that the sharp rim is in the open.
  return {d.add("cylinder", kAdd, p.frame, {{"radius", disc}, {"height", p.r}}),
          d.add("cone", kAdd, shifted(p.frame, 0, 0, 0.9 * p.r),
                {{"radius_bottom", p.r}, {"radius_top", d.chance(0.5) ? 0 : disc}, {"height", h}})};
}

Ids tilted_slab(Draft& d, const Place& p) {
  const double h = 0.6 * p.r;
  const Transform at = turned(shifted(p.frame, 0, 0, 0.2 * h), 0, sharp(d));
  return {d.add("block", kAdd, p.frame, {{"dx", 2 * p.r}, {"dy", 2 * p.r}, {"dz", h}}),
          d.add("block", kAdd, at, {{"dx", 2.4 * p.r}, {"dy", 2.4 * p.r}, {"dz", h}})};
}

// --- Thin walls and gaps ----------------------------------------------------------------------

double thin(Draft& d, const Place& p) { return p.l * d.log_uniform(0.02, 0.9); }

Ids thin_tube(Draft& d, const Place& p) {
  const double h = p.r * d.random.uniform(0.5, 1.5);
  return {d.add("cylinder", kAdd, p.frame, {{"radius", p.r}, {"height", h}}),
          d.add("cylinder", kCut, shifted(p.frame, 0, 0, 0.3 * h),
                {{"radius", p.r - std::min(0.5 * p.r, thin(d, p))}, {"height", h}})};
}

Ids thin_floor(Draft& d, const Place& p) {
  const double floor = thin(d, p);
  return {d.add("cylinder", kCut, shifted(p.frame, 0, 0, -p.depth + floor),
                {{"radius", 0.6 * p.r}, {"height", p.depth + p.l}})};
}

Ids fin(Draft& d, const Place& p) {
  return {d.add("block", kAdd, turned(p.frame, 2, d.random.uniform(0, pi)),
                {{"dx", 2 * p.r}, {"dy", thin(d, p)}, {"dz", p.r}})};
}

Ids narrow_gap(Draft& d, const Place& p) {
  const double gap = thin(d, p), h = p.r * d.random.uniform(0.4, 1);
  return {d.add("block", kAdd, shifted(p.frame, -0.5 * (p.r + gap), 0, 0),
                {{"dx", p.r}, {"dy", p.r}, {"dz", h}}),
          d.add("block", kAdd, shifted(p.frame, 0.5 * (p.r + gap), 0, 0),
                {{"dx", p.r}, {"dy", p.r}, {"dz", h}})};
}

Ids close_holes(Draft& d, const Place& p) {
  const double wall = thin(d, p), r = 0.45 * p.r, h = p.r;
  return {d.add("slot", kAdd, p.frame, {{"length", 3 * p.r}, {"width", 1.6 * p.r}, {"height", h}}),
          d.add("cylinder", kCut, shifted(p.frame, -r - 0.5 * wall, 0, 0.3 * h),
                {{"radius", r}, {"height", h}}),
          d.add("cylinder", kCut, shifted(p.frame, r + 0.5 * wall, 0, 0.3 * h),
                {{"radius", r}, {"height", h}})};
}

// --- Rims and merging -------------------------------------------------------------------------

/// A share of an overlap, from a graze to nearly all.
double bite(Draft& d) {
  return d.chance(0.5) ? d.log_uniform(1e-5, 0.1) : d.random.uniform(0.1, 0.9);
}

Ids hole_over_rim(Draft& d, const Place& p) {
  const double r = p.r * d.random.uniform(0.15, 0.5), h = p.r;
  return {d.add("cylinder", kAdd, p.frame, {{"radius", p.r}, {"height", h}}),
          d.add("cylinder", kCut, shifted(p.frame, p.r + r - 2 * r * bite(d), 0, 0.3 * h),
                {{"radius", r}, {"height", h}})};
}

Ids merging_holes(Draft& d, const Place& p) {
  const double r = 0.5 * p.r, h = p.r, apart = 2 * r * (1 - bite(d));
  return {d.add("block", kAdd, p.frame, {{"dx", 3 * p.r}, {"dy", 2 * p.r}, {"dz", h}}),
          d.add("cylinder", kCut, shifted(p.frame, -0.5 * apart, 0, 0.2 * h),
                {{"radius", r}, {"height", h}}),
          d.add("cylinder", kCut, shifted(p.frame, 0.5 * apart, 0, 0.4 * h),
                {{"radius", r}, {"height", h}})};
}

Ids merging_bosses(Draft& d, const Place& p) {
  const double r = p.r * d.random.uniform(0.4, 1), s = p.r * d.random.uniform(0.4, 1);
  return {d.add("cylinder", kAdd, p.frame, {{"radius", r}, {"height", p.r}}),
          d.add("cylinder", kAdd, shifted(p.frame, (r + s) * (1 - bite(d)), 0, 0),
                {{"radius", s}, {"height", 0.7 * p.r}})};
}

Ids slot_over_rim(Draft& d, const Place& p) {
  const double h = p.r, w = p.r * d.random.uniform(0.2, 0.7);
  return {d.add("block", kAdd, p.frame, {{"dx", 2 * p.r}, {"dy", 2 * p.r}, {"dz", h}}),
          d.add("slot", kCut, shifted(p.frame, 2 * p.r - 2 * w * bite(d), 0, 0.5 * h),
                {{"length", 2 * p.r}, {"width", w}, {"height", h}})};
}

Ids ball_over_rim(Draft& d, const Place& p) {
  const double h = p.r, r = p.r * d.random.uniform(0.2, 0.6);
  return {d.add("block", kAdd, p.frame, {{"dx", 2 * p.r}, {"dy", 2 * p.r}, {"dz", h}}),
          d.add("sphere", d.chance(0.5) ? kAdd : kCut,
                shifted(p.frame, p.r + r * (1 - 2 * bite(d)), 0, h * d.random.uniform(0.5, 1)),
                {{"radius", r}})};
}

// --- Small parts ------------------------------------------------------------------------------

Ids pin(Draft& d, const Place& p) {
  const double r = p.l * d.log_uniform(0.03, 0.9), h = p.l * d.log_uniform(0.1, 4);
  return {
      d.add("cylinder", kAdd, shifted(p.frame, 0.2 * p.r, 0, 0), {{"radius", r}, {"height", h}})};
}

Ids pinhole(Draft& d, const Place& p) {
  const double r = p.l * d.log_uniform(0.03, 0.9), h = p.depth * d.random.uniform(0.3, 1.2);
  return {d.add("cylinder", kCut, shifted(p.frame, 0, 0.2 * p.r, -h),
                {{"radius", r}, {"height", h + p.l}})};
}

Ids step(Draft& d, const Place& p) {
  return {d.add("block", kAdd, p.frame,
                {{"dx", p.r}, {"dy", p.r}, {"dz", p.l * d.log_uniform(1e-3, 0.9)}})};
}

Ids offset_stack(Draft& d, const Place& p) {
  const double shift = p.l * d.log_uniform(1e-4, 0.5), h = 0.5 * p.r;
  return {
      d.add("block", kAdd, p.frame, {{"dx", p.r}, {"dy", p.r}, {"dz", h}}),
      d.add("block", kAdd, shifted(p.frame, shift, 0, h), {{"dx", p.r}, {"dy", p.r}, {"dz", h}})};
}

Ids point_cone(Draft& d, const Place& p) {
  return {d.add("cone", kAdd, p.frame,
                {{"radius_bottom", p.r * d.random.uniform(0.3, 1)},
                 {"radius_top", 0},
                 {"height", p.r * d.random.uniform(0.3, 1.5)}})};
}

Ids small_bead(Draft& d, const Place& p) {
  return {d.add("torus", d.chance(0.5) ? kAdd : kCut, p.frame,
                {{"major_radius", 0.6 * p.r}, {"minor_radius", p.l * d.log_uniform(0.05, 0.9)}})};
}

// --- Anything ---------------------------------------------------------------------------------

Ids soup(Draft& d, const Place& p) {
  Ids ids;
  for (std::uint64_t n = 1 + d.random.below(4); n > 0; --n)
    ids.push_back(add_any_feature(d, p.frame, p.r, p.depth, p.l));
  return ids;
}

constexpr Make kTangent[] = {
    cylinder_inside_cylinder, cylinder_in_square, round_end,   domed_pin,       crossing_holes,
    hole_in_pocket,           ball_under_face,    bead_on_rim, hole_beside_pin, rod_under_face};
constexpr Make kCoincident[] = {same_footprint, same_radius, plugged_hole, flush_cut,
                                twice_the_same, same_cone,   side_by_side};
constexpr Make kWedge[] = {sharp_prism, ramp, groove, pie, flat_cone, tilted_slab};
constexpr Make kThin[] = {thin_tube, thin_floor, fin, narrow_gap, close_holes};
constexpr Make kAtRim[] = {hole_over_rim, merging_holes, merging_bosses, slot_over_rim,
                           ball_over_rim};
constexpr Make kSmall[] = {pin, pinhole, step, offset_stack, point_cone, small_bead};
constexpr Make kSoup[] = {soup};

constexpr std::array<std::span<const Make>, kTroubles> kFamilies{
    kTangent, kCoincident, kWedge, kThin, kAtRim, kSmall, kSoup};

}  // namespace

std::vector<std::string> add_trouble(Draft& d, Trouble family, const Site& site) {
  const double r = std::max(0.6 * site.radius, 1.5 * d.length) * d.random.uniform(0.5, 1.2);
  const Place place{turned(site.frame, 2, d.chance(0.5) ? 0 : d.random.uniform(0, pi)), r,
                    std::max(site.depth, 2 * d.length), d.length};
  const std::span<const Make> recipes = kFamilies[static_cast<std::size_t>(family)];
  return recipes[d.random.below(recipes.size())](d, place);
}

}  // namespace remeshd::campaign
