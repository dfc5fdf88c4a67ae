#pragma once

#include <algorithm>
#include <cmath>

#include "engine/base/vec.h"

namespace remeshd::kernel {

/// Exact signs by CGAL; called where the filter below cannot decide.
int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
int exact_in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& p);
/// exact_in_sphere behind a filter with the error bound of Shewchuk 1997.
int filtered_in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& p);

/// Sign of det(b - a, c - a, d - a): +1 for a positive tet. Exact; floating-point filter with the
/// error bound of Shewchuk 1997 in front.
inline int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  constexpr double kBound = (7.0 + 56.0 * 0x1.0p-53) * 0x1.0p-53;
  const double adx = a.x - d.x, ady = a.y - d.y, adz = a.z - d.z;
  const double bdx = b.x - d.x, bdy = b.y - d.y, bdz = b.z - d.z;
  const double cdx = c.x - d.x, cdy = c.y - d.y, cdz = c.z - d.z;
  const double bxcy = bdx * cdy, cxby = cdx * bdy;
  const double cxay = cdx * ady, axcy = adx * cdy;
  const double axby = adx * bdy, bxay = bdx * ady;
  const double det = adz * (bxcy - cxby) + bdz * (cxay - axcy) + cdz * (axby - bxay);
  const double permanent = (std::fabs(bxcy) + std::fabs(cxby)) * std::fabs(adz) +
                           (std::fabs(cxay) + std::fabs(axcy)) * std::fabs(bdz) +
                           (std::fabs(axby) + std::fabs(bxay)) * std::fabs(cdz);
  if (std::fabs(det) > kBound * permanent) return det > 0 ? -1 : 1;
  return exact_orientation(a, b, c, d);
}

/// On which side of the circumsphere of one positive tet points lie, by the determinant expanded
/// along the row of the point. Cheap, above all for several points, but it does not decide near the
/// sphere.
class SphereTest {
 public:
  SphereTest(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) : origin_(a) {
    const Vec3 ab = b - a, ac = c - a, ad = d - a;
    const Vec3 cd = cross(ac, ad);
    volume_ = dot(ab, cd);
    normal_ = norm2(ab) * cd + norm2(ac) * cross(ad, ab) + norm2(ad) * cross(ab, ac);
    const double size = std::max({span(ab), span(ac), span(ad)});
    size2_ = size * size;
    unsure_ = kUnsure * size2_ * size;
  }

  /// +1 where p lies inside, -1 outside, 0 where rounding leaves that open.
  [[nodiscard]] int side(const Vec3& p) const {
    const Vec3 ap = p - origin_;
    const double p2 = norm2(ap);
    const double outside = volume_ * p2 - dot(ap, normal_);
    if (std::fabs(outside) <= unsure_ * (p2 + size2_)) return 0;
    return outside > 0 ? -1 : 1;
  }

 private:
  /// With edges from a up to s long and p at a distance r from a, the terms of `volume_ * p2` add
  /// up to less than 2 s^3 r^2 and those of the other product to less than 6 s^4 r, each rounded
  /// fewer than 20 times by 2^-53: the error is below 1.4e-14 s^3 (r^2 + s r).
  static constexpr double kUnsure = 1e-12;
  /// The 1-norm: at least the length.
  static double span(const Vec3& v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }

  Vec3 origin_, normal_;
  double volume_ = 0, size2_ = 0, unsure_ = 0;
};

/// +1 where p lies inside the circumsphere of the positive tet abcd, 0 on it, -1 outside. Exact; an
/// error bound from the size of the tet decides nearly always, and saves the costlier filter and
/// exact arithmetic.
inline int in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& p) {
  const Vec3 ae = a - p, be = b - p, ce = c - p, de = d - p;
  const double ab = ae.x * be.y - be.x * ae.y, bc = be.x * ce.y - ce.x * be.y;
  const double cd = ce.x * de.y - de.x * ce.y, da = de.x * ae.y - ae.x * de.y;
  const double ac = ae.x * ce.y - ce.x * ae.y, bd = be.x * de.y - de.x * be.y;
  const double abc = ae.z * bc - be.z * ac + ce.z * ab, bcd = be.z * cd - ce.z * bd + de.z * bc;
  const double cda = ce.z * da + de.z * ac + ae.z * cd, dab = de.z * ab + ae.z * bd + be.z * da;
  const double det = (norm2(de) * abc - norm2(ce) * dab) + (norm2(be) * cda - norm2(ae) * bcd);
  const auto largest = [](double q, double r, double s, double t) {
    return std::max(std::max(std::fabs(q), std::fabs(r)), std::max(std::fabs(s), std::fabs(t)));
  };
  const double x = largest(ae.x, be.x, ce.x, de.x), y = largest(ae.y, be.y, ce.y, de.y);
  const double z = largest(ae.z, be.z, ce.z, de.z), size = std::max(std::max(x, y), z);
  // The permanent of `filtered_in_sphere` is at most 4 * (3 * 2xy * z) * 3 size^2.
  constexpr double kBound = 73 * (16.0 + 224.0 * 0x1.0p-53) * 0x1.0p-53;
  if (std::fabs(det) > kBound * (x * y * z) * (size * size)) return det > 0 ? -1 : 1;
  return filtered_in_sphere(a, b, c, d, p);
}

}  // namespace remeshd::kernel
