#include "tests/campaign/bodies.h"

#include <array>
#include <cmath>
#include <numbers>

namespace remeshd::campaign {
namespace {

using std::numbers::pi;
constexpr double kRim = 1.3;  // free rim round a site's disc, in l

/// Looks along +x, -x, +y, -y, +z, -z of `frame`.
Transform facing(const Transform& frame, int direction) {
  switch (direction) {
    case 0:
      return turned(frame, 1, pi / 2);
    case 1:
      return turned(frame, 1, -pi / 2);
    case 2:
      return turned(frame, 0, -pi / 2);
    case 3:
      return turned(frame, 0, pi / 2);
    case 4:
      return frame;
    default:
      return turned(frame, 0, pi);
  }
}

/// Sites in a grid on the rectangle width x depth about the origin of `frame`.
void grid_sites(Draft& d, const Transform& frame, double width, double depth, double below) {
  const double l = d.length;
  const double pitch = l * (d.dense ? 4.4 : d.random.uniform(4.6, 8));
  const double w = width - l, h = depth - l;
  const int nx = std::max(1, static_cast<int>(w / pitch));
  const int ny = std::max(1, static_cast<int>(h / pitch));
  const double radius = 0.5 * std::min(w / nx, h / ny) - 0.8 * l;
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j < ny; ++j)
      d.sites.push_back(
          {shifted(frame, (i + 0.5) * w / nx - 0.5 * w, (j + 0.5) * h / ny - 0.5 * h, 0),
           radius,
           below,
           {}});
}

/// Sites on the ring between two radii about the axis of `frame`.
void ring_sites(Draft& d, const Transform& frame, double inner, double outer, double below) {
  const double middle = 0.5 * (inner + outer);
  const double radius = 0.5 * (outer - inner) - kRim * d.length;
  const double pitch = std::max(2 * radius + 1.5 * d.length, 4.5 * d.length);
  const int n = static_cast<int>(2 * pi * middle / pitch);
  const double start = d.random.uniform(0, 1);
  for (int k = 0; k < n; ++k) {
    Transform at = turned(frame, 2, start + 2 * pi * k / n);
    d.sites.push_back({shifted(at, middle, 0, 0), radius, below, {}});
  }
}

void one_site(Draft& d, const Transform& frame, double radius, double below) {
  d.sites.push_back({frame, radius - kRim * d.length, below, {}});
}

void block(Draft& d, double size) {
  const double w = size, h = size * d.random.uniform(0.4, 1),
               t = size * (d.dense ? 0.1 : d.random.uniform(0.08, 0.4));
  d.body.push_back(d.add("block", Nature::Additive, {}, {{"dx", w}, {"dy", h}, {"dz", t}}));
  find_length(d);
  grid_sites(d, shifted({}, 0, 0, t), w, h, t);
  if (t > 6 * d.length) {
    one_site(d, facing(shifted({}, w / 2, 0, t / 2), 0), t / 2, 0);
    one_site(d, facing(shifted({}, -w / 2, 0, t / 2), 1), t / 2, 0);
  }
}

void stacked_blocks(Draft& d, double size) {
  const double w = size, h = size * d.random.uniform(0.5, 0.9),
               t = size * d.random.uniform(0.2, 0.35);
  const double w2 = w * d.random.uniform(0.35, 0.6);
  d.body.push_back(d.add("block", Nature::Additive, {}, {{"dx", w}, {"dy", h}, {"dz", t}}));
  // Same depth: two pairs of faces are coplanar; and the faces between the two coincide.
  d.body.push_back(d.add("block", Nature::Additive, shifted({}, 0.5 * (w - w2), 0, t),
                         {{"dx", w2}, {"dy", h}, {"dz", t}}));
  find_length(d);
  grid_sites(d, shifted({}, -0.5 * w2, 0, t), w - w2, h, t);
  grid_sites(d, shifted({}, 0.5 * (w - w2), 0, 2 * t), w2, h, 2 * t);
}

void disc(Draft& d, double size) {
  const double r = size / 2, t = size * d.random.uniform(0.15, 0.5);
  d.body.push_back(d.add("cylinder", Nature::Additive, {}, {{"radius", r}, {"height", t}}));
  find_length(d);
  const double inner = r * d.random.uniform(0.35, 0.5);
  one_site(d, shifted({}, 0, 0, t), inner, t);
  ring_sites(d, shifted({}, 0, 0, t), inner, r, t);
}

void slot(Draft& d, double size) {
  const double w = size * d.random.uniform(0.3, 0.6), t = size * d.random.uniform(0.12, 0.3);
  d.body.push_back(
      d.add("slot", Nature::Additive, {}, {{"length", size}, {"width", w}, {"height", t}}));
  find_length(d);
  grid_sites(d, shifted({}, 0, 0, t), size - 0.4 * w, 0.85 * w, t);
}

void polygon_plate(Draft& d, double size) {
  const int n = 3 + static_cast<int>(d.random.below(6));
  const double r = size / 2, t = size * d.random.uniform(0.15, 0.4);
  d.body.push_back(d.add_outline("prism", Nature::Additive, {}, polygon(n, r), {{"height", t}}));
  find_length(d);
  const double free = r * std::cos(pi / n);
  const double inner = free * d.random.uniform(0.35, 0.5);
  one_site(d, shifted({}, 0, 0, t), inner, t);
  ring_sites(d, shifted({}, 0, 0, t), inner, free, t);
}

void angle_plate(Draft& d, double size) {
  const double a = size, b = size * d.random.uniform(0.3, 0.5),
               t = size * d.random.uniform(0.15, 0.4);
  std::vector<ProfileEntry> profile = outline({{0, 0}, {a, 0}, {a, b}, {b, b}, {b, a}, {0, a}});
  // An arc in the inner corner, now and then.
  if (d.chance(0.5)) {
    const double f = 0.25 * b, m = f * (1 - std::sqrt(0.5));
    profile = outline({{0, 0}, {a, 0}, {a, b}, {b + f, b}, {b, b + f}, {b, a}, {0, a}});
    profile[4].through = std::array<Scalar, 2>{b + m, b + m};
  }
  d.body.push_back(d.add_outline("prism", Nature::Additive, {}, profile, {{"height", t}}));
  find_length(d);
  grid_sites(d, shifted({}, 0.5 * (a + 1.3 * b), b / 2, t), a - 1.3 * b, b, t);
  grid_sites(d, shifted({}, b / 2, 0.5 * (a + 1.3 * b), t), b, a - 1.3 * b, t);
}

void flange(Draft& d, double size) {
  const double r = size / 2, t = size * d.random.uniform(0.12, 0.2);
  const double hub = r * d.random.uniform(0.35, 0.5), h = t + size * d.random.uniform(0.1, 0.3);
  const double bore = d.chance(0.5) ? 0 : hub * d.random.uniform(0.4, 0.5);
  const double angle = d.chance(0.7) ? 360 : d.random.uniform(120, 300);
  d.body.push_back(d.add_outline(
      "revolution", Nature::Additive, {},
      outline({{bore, 0}, {r, 0}, {r, t}, {hub, t}, {hub, h}, {bore, h}}), {{"angle", angle}}));
  find_length(d);
  if (angle == 360) ring_sites(d, shifted({}, 0, 0, t), hub, r, t);
  if (bore == 0 && angle == 360) one_site(d, shifted({}, 0, 0, h), hub, h);
}

void tube(Draft& d, double size) {
  const double r = size / 2, t = size * d.random.uniform(0.3, 0.6);
  d.body.push_back(d.add("cylinder", Nature::Additive, {}, {{"radius", r}, {"height", t}}));
  const double bore = r * d.random.uniform(0.3, 0.5);
  d.body.push_back(d.add("cylinder", Nature::Subtractive, {}, {{"radius", bore}, {"height", t}}));
  find_length(d);
  ring_sites(d, shifted({}, 0, 0, t), bore, r, t);
}

void ball(Draft& d, double size) {
  const double r = size / 2;
  d.body.push_back(d.add("sphere", Nature::Additive, {}, {{"radius", r}}));
  find_length(d);
  // The discs lie on flat caps a little inside.
  const double free = 0.35 * r;
  for (int k = 0; k < 6; ++k)
    one_site(d, shifted(facing({}, k), 0, 0, std::sqrt(r * r - free * free)), free, 0.6 * r);
}

void ring(Draft& d, double size) {
  const double major = size / 2, minor = major * d.random.uniform(0.3, 0.5);
  d.body.push_back(
      d.add("torus", Nature::Additive, {}, {{"major_radius", major}, {"minor_radius", minor}}));
  find_length(d);
  const double free = 0.5 * minor;
  for (int k = 0; k < 5; ++k)
    one_site(d,
             shifted(facing(turned({}, 2, 2 * pi * k / 5), 0), 0, 0,
                     major + std::sqrt(minor * minor - free * free)),
             free, minor);
}

void frustum(Draft& d, double size) {
  const double r = size / 2, top = r * d.random.uniform(0.5, 0.8),
               h = size * d.random.uniform(0.3, 0.7);
  d.body.push_back(d.add("cone", Nature::Additive, {},
                         {{"radius_bottom", r}, {"radius_top", top}, {"height", h}}));
  find_length(d);
  one_site(d, shifted({}, 0, 0, h), top, h);
  one_site(d, facing({}, 5), 0.6 * r, h);
}

}  // namespace

void add_body(Draft& d) {
  using Make = void (*)(Draft&, double);
  // Plates twice: most parts are.
  static constexpr std::array<Make, 14> kBodies{block, block,         stacked_blocks, disc,   disc,
                                                slot,  polygon_plate, angle_plate,    flange, tube,
                                                ball,  ring,          frustum,        block};
  const double size = d.log_uniform(0.5, 500);
  kBodies[d.dense ? 0 : d.random.below(kBodies.size())](d, size);
}

}  // namespace remeshd::campaign
