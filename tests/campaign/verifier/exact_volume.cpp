#include "tests/campaign/verifier/exact_volume.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

namespace remeshd::campaign {
namespace {

using Rational = boost::multiprecision::cpp_rational;

int exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto minus = [](double x, double y) -> Rational { return Rational(x) - Rational(y); };
  const Rational ux = minus(b.x, a.x), uy = minus(b.y, a.y), uz = minus(b.z, a.z);
  const Rational vx = minus(c.x, a.x), vy = minus(c.y, a.y), vz = minus(c.z, a.z);
  const Rational wx = minus(d.x, a.x), wy = minus(d.y, a.y), wz = minus(d.z, a.z);
  const Rational volume =
      (uy * vz - uz * vy) * wx + (uz * vx - ux * vz) * wy + (ux * vy - uy * vx) * wz;
  return volume.sign();
}

}  // namespace

int volume_sign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  const double volume = dot(cross(u, v), w);
  // No term is larger than this product, and rounding is below 1e-14 of the sum of the terms.
  const double most = (std::fabs(u.x) + std::fabs(u.y) + std::fabs(u.z)) *
                      (std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z)) *
                      (std::fabs(w.x) + std::fabs(w.y) + std::fabs(w.z));
  if (std::fabs(volume) > 1e-14 * most) return volume > 0 ? 1 : -1;
  return exact(a, b, c, d);
}

}  // namespace remeshd::campaign
