#include "engine/difference/line_crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace remeshd {
namespace {

double value(std::span<const double> polynomial, double t) {
  double sum = 0;
  for (auto it = polynomial.rbegin(); it != polynomial.rend(); ++it) sum = sum * t + *it;
  return sum;
}

/// Root between a and b, where the polynomial has different signs.
double bisect(std::span<const double> polynomial, double a, double b) {
  const bool rising = value(polynomial, a) < 0;
  for (int i = 0; i < 200; ++i) {
    const double m = 0.5 * (a + b);
    if (m <= std::min(a, b) || m >= std::max(a, b)) break;
    ((value(polynomial, m) < 0) == rising ? a : b) = m;
  }
  return 0.5 * (a + b);
}

/// Real roots in [begin, end] of a polynomial by rising powers: between the extremes, which are the
/// roots of its derivative, it is monotone.
std::vector<double> roots(std::vector<double> polynomial, double begin, double end) {
  while (polynomial.size() > 1 && polynomial.back() == 0) polynomial.pop_back();
  if (polynomial.size() < 2) return {};
  std::vector<double> derivative;
  for (std::size_t i = 1; i < polynomial.size(); ++i)
    derivative.push_back(static_cast<double>(i) * polynomial[i]);
  std::vector<double> stops{begin};
  for (const double t : roots(derivative, begin, end)) stops.push_back(t);
  stops.push_back(end);
  std::vector<double> out;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i)
    if ((value(polynomial, stops[i]) < 0) != (value(polynomial, stops[i + 1]) < 0))
      out.push_back(bisect(polynomial, stops[i], stops[i + 1]));
  return out;
}

/// Roots of a t^2 + 2 b t + c.
void append_quadratic(double a, double b, double c, std::vector<double>& out) {
  if (a == 0) {
    if (b != 0) out.push_back(-c / (2 * b));
    return;
  }
  const double discriminant = b * b - a * c;
  if (discriminant <= 0) return;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  out.push_back(q / a);
  if (q != 0) out.push_back(c / q);
}

}  // namespace

void append_crossings(const Surface& surface, const Line& line, std::vector<double>& out) {
  const Transform to_local = rigid_inverse(surface.frame);
  const Vec3 p = to_local.apply(line.p);
  const Vec3 d = to_local.rotate(line.direction);
  const std::size_t first = out.size();
  switch (surface.kind) {
    case Surface::Kind::Plane:
      if (d.z != 0) out.push_back(-p.z / d.z);
      break;
    case Surface::Kind::Cylinder:
      append_quadratic(d.x * d.x + d.y * d.y, p.x * d.x + p.y * d.y,
                       p.x * p.x + p.y * p.y - surface.r1 * surface.r1, out);
      break;
    case Surface::Kind::Cone: {
      const double r = surface.r1 + surface.r2 * p.z, s = surface.r2 * d.z;
      append_quadratic(d.x * d.x + d.y * d.y - s * s, p.x * d.x + p.y * d.y - r * s,
                       p.x * p.x + p.y * p.y - r * r, out);
      break;
    }
    case Surface::Kind::Sphere:
      append_quadratic(norm2(d), dot(p, d), norm2(p) - surface.r1 * surface.r1, out);
      break;
    case Surface::Kind::Torus: {
      // From the point nearest to the centre, where the powers of t lose least.
      const double shift = -dot(p, d);
      const Vec3 q = p + shift * d;
      const double k = norm2(q) + surface.r1 * surface.r1 - surface.r2 * surface.r2;
      const double f = 4 * surface.r1 * surface.r1;
      // (t^2 + k)^2 = f ((q.x + t d.x)^2 + (q.y + t d.y)^2)
      for (const double t :
           roots({k * k - f * (q.x * q.x + q.y * q.y), -2 * f * (q.x * d.x + q.y * d.y),
                  2 * k - f * (d.x * d.x + d.y * d.y), 0, 1},
                 line.begin - shift, line.end - shift))
        out.push_back(t + shift);
      break;
    }
  }
  const auto outside = [&](double t) { return !(t > line.begin && t < line.end); };
  out.erase(std::remove_if(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(), outside),
            out.end());
}

bool clip(Line& line, const Box& box) {
  double begin = line.begin, end = line.end;
  const std::array<std::array<double, 4>, 3> axes{
      {{line.p.x, line.direction.x, box.lo.x, box.hi.x},
       {line.p.y, line.direction.y, box.lo.y, box.hi.y},
       {line.p.z, line.direction.z, box.lo.z, box.hi.z}}};
  for (const auto& [p, d, lo, hi] : axes) {
    if (d == 0) {
      if (p < lo || p > hi) return false;
      continue;
    }
    const double a = (lo - p) / d, b = (hi - p) / d;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  line.begin = begin;
  line.end = end;
  return begin < end;
}

}  // namespace remeshd
