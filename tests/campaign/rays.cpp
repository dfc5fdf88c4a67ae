#include "tests/campaign/rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace remeshd::campaign {
namespace {

double evaluate_at(std::span<const double> c, double t) {
  double sum = 0;
  for (std::size_t k = c.size(); k-- > 0;) sum = sum * t + c[k];
  return sum;
}

/// Real roots of the polynomial c[0] + c[1] t + ... in [lo, hi]: between the roots of its
/// derivative it has one at most, which bisection finds.
void roots(std::span<const double> c, double lo, double hi, std::vector<double>& out) {
  if (c.size() < 2) return;
  std::vector<double> stops{lo};
  if (c.size() > 2) {
    std::vector<double> derivative;
    for (std::size_t k = 1; k < c.size(); ++k) derivative.push_back(static_cast<double>(k) * c[k]);
    roots(derivative, lo, hi, stops);
  }
  stops.push_back(hi);
  std::sort(stops.begin(), stops.end());
  for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
    double a = stops[k], b = stops[k + 1];
    const bool rising = evaluate_at(c, a) < 0;
    if (rising == (evaluate_at(c, b) < 0)) continue;
    for (int i = 0; i < 80 && b - a > 1e-16 * (std::fabs(a) + std::fabs(b)); ++i) {
      const double m = 0.5 * (a + b);
      ((evaluate_at(c, m) < 0) == rising ? a : b) = m;
    }
    out.push_back(0.5 * (a + b));
  }
}

/// Roots of a t^2 + 2 b t + c.
void quadratic(double a, double b, double c, std::vector<double>& out) {
  if (a == 0) {
    if (b != 0) out.push_back(-0.5 * c / b);
    return;
  }
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  out.push_back(q / a);
  if (q != 0) out.push_back(c / q);
}

void torus(double major, double minor, const Vec3& p, const Vec3& d, std::vector<double>& out) {
  // About the point nearest to the centre, in units of the torus' size, the numbers stay small.
  const double size = std::fabs(major) + minor;
  const double shift = -dot(p, d);
  const Vec3 q = (p + shift * d) / size;
  const double q2 = norm2(q);
  if (q2 > 1) return;
  const double big = major / size, small = minor / size;
  const double k = q2 + big * big - small * small;
  // (q2 + t^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + y^2), with q orthogonal to d.
  const double r4 = 4 * big * big;
  const std::array<double, 5> c{k * k - r4 * (q.x * q.x + q.y * q.y),
                                -2 * r4 * (q.x * d.x + q.y * d.y),
                                2 * k - r4 * (d.x * d.x + d.y * d.y), 0, 1};
  std::vector<double> found;
  roots(c, -1.5, 1.5, found);
  for (const double t : found) out.push_back(t * size + shift);
}

bool meets(const Box& box, const Vec3& p, const Vec3& d, double from, double to) {
  const std::array<std::array<double, 4>, 3> axes{{{p.x, d.x, box.lo.x, box.hi.x},
                                                   {p.y, d.y, box.lo.y, box.hi.y},
                                                   {p.z, d.z, box.lo.z, box.hi.z}}};
  const double margin = 1e-9 * box.diagonal();
  for (const auto& [start, step, lo, hi] : axes) {
    if (step == 0) {
      if (start < lo - margin || start > hi + margin) return false;
      continue;
    }
    const double a = (lo - margin - start) / step, b = (hi + margin - start) / step;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return from <= to;
}

}  // namespace

void intersect(const Surface& surface, const Vec3& p, const Vec3& d, std::vector<double>& out) {
  const Transform inverse = rigid_inverse(surface.frame);
  const Vec3 q = inverse.apply(p), e = inverse.rotate(d);
  switch (surface.kind) {
    case Surface::Kind::Plane:
      if (e.z != 0) out.push_back(-q.z / e.z);
      return;
    case Surface::Kind::Cylinder:
      quadratic(e.x * e.x + e.y * e.y, q.x * e.x + q.y * e.y,
                q.x * q.x + q.y * q.y - surface.r1 * surface.r1, out);
      return;
    case Surface::Kind::Cone: {
      const double r = surface.r1 + surface.r2 * q.z, s = surface.r2 * e.z;
      quadratic(e.x * e.x + e.y * e.y - s * s, q.x * e.x + q.y * e.y - r * s,
                q.x * q.x + q.y * q.y - r * r, out);
      return;
    }
    case Surface::Kind::Sphere:
      quadratic(1, dot(q, e), norm2(q) - surface.r1 * surface.r1, out);
      return;
    case Surface::Kind::Torus:
      torus(surface.r1, surface.r2, q, e, out);
      return;
  }
}

Vec3 spiral_direction(int k, int n) {
  constexpr double kGoldenAngle = 2.399963229728653;
  const double z = 1 - (2 * k + 1.0) / n, r = std::sqrt(1 - z * z), a = kGoldenAngle * k;
  return {r * std::cos(a), r * std::sin(a), z};
}

Rays::Rays(const Membership& membership)
    : membership_(membership), same_(1e-12 * membership.bounds().diagonal()) {}

void Rays::crossings(const Vec3& p, const Vec3& d, double from, double to,
                     std::vector<double>& out) const {
  for (const Solid& solid : membership_.solids()) {
    if (!meets(solid.bounds(), p, d, from, to)) continue;
    for (const SolidFace& face : solid.faces()) intersect(face.surface, p, d, out);
  }
  std::erase_if(out, [&](double t) { return !(t > from && t < to); });
  std::sort(out.begin(), out.end());
}

std::vector<std::pair<double, double>> Rays::material(const Vec3& p, const Vec3& d, double from,
                                                      double to) const {
  std::vector<double> stops;
  crossings(p, d, from, to, stops);
  stops.push_back(to);
  std::vector<std::pair<double, double>> result;
  double last = from;
  for (const double t : stops) {
    if (t - last <= same_) continue;
    if (membership_.inside(p + 0.5 * (last + t) * d)) {
      if (!result.empty() && result.back().second == last)
        result.back().second = t;
      else
        result.emplace_back(last, t);
    }
    last = t;
  }
  return result;
}

bool Rays::boundary_within(const Vec3& p, double reach) const {
  constexpr int kDirections = 200;
  for (int k = 0; k < kDirections; ++k)
    if (first_change(p, spiral_direction(k, kDirections), 0, reach) < reach) return true;
  return false;
}

double Rays::first_change(const Vec3& p, const Vec3& d, double from, double to) const {
  std::vector<double> stops;
  crossings(p, d, from, to, stops);
  stops.push_back(to);
  double last = from;
  bool any = false, nature = false;
  for (const double t : stops) {
    if (t - last <= same_) continue;
    const bool inside = membership_.inside(p + 0.5 * (last + t) * d);
    if (any && inside != nature) return last;
    any = true;
    nature = inside;
    last = t;
  }
  return to;
}

}  // namespace remeshd::campaign
