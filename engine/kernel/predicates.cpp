#include "engine/kernel/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace remeshd::kernel {

namespace {
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
K::Point_3 to_cgal(const Vec3& p) { return {p.x, p.y, p.z}; }
}  // namespace

int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return CGAL::orientation(to_cgal(a), to_cgal(b), to_cgal(c), to_cgal(d));
}

int exact_in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& p) {
  return CGAL::side_of_oriented_sphere(to_cgal(a), to_cgal(b), to_cgal(c), to_cgal(d), to_cgal(p));
}

int filtered_in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& p) {
  constexpr double kBound = (16.0 + 224.0 * 0x1.0p-53) * 0x1.0p-53;
  const double aex = a.x - p.x, aey = a.y - p.y, aez = a.z - p.z;
  const double bex = b.x - p.x, bey = b.y - p.y, bez = b.z - p.z;
  const double cex = c.x - p.x, cey = c.y - p.y, cez = c.z - p.z;
  const double dex = d.x - p.x, dey = d.y - p.y, dez = d.z - p.z;
  const double axby = aex * bey, bxay = bex * aey, ab = axby - bxay;
  const double bxcy = bex * cey, cxby = cex * bey, bc = bxcy - cxby;
  const double cxdy = cex * dey, dxcy = dex * cey, cd = cxdy - dxcy;
  const double dxay = dex * aey, axdy = aex * dey, da = dxay - axdy;
  const double axcy = aex * cey, cxay = cex * aey, ac = axcy - cxay;
  const double bxdy = bex * dey, dxby = dex * bey, bd = bxdy - dxby;
  const double abc = aez * bc - bez * ac + cez * ab;
  const double bcd = bez * cd - cez * bd + dez * bc;
  const double cda = cez * da + dez * ac + aez * cd;
  const double dab = dez * ab + aez * bd + bez * da;
  const double alift = aex * aex + aey * aey + aez * aez;
  const double blift = bex * bex + bey * bey + bez * bez;
  const double clift = cex * cex + cey * cey + cez * cez;
  const double dlift = dex * dex + dey * dey + dez * dez;
  const double det = (dlift * abc - clift * dab) + (blift * cda - alift * bcd);
  const double az = std::fabs(aez), bz = std::fabs(bez), cz = std::fabs(cez), dz = std::fabs(dez);
  const double pab = std::fabs(axby) + std::fabs(bxay), pbc = std::fabs(bxcy) + std::fabs(cxby);
  const double pcd = std::fabs(cxdy) + std::fabs(dxcy), pda = std::fabs(dxay) + std::fabs(axdy);
  const double pac = std::fabs(axcy) + std::fabs(cxay), pbd = std::fabs(bxdy) + std::fabs(dxby);
  const double permanent =
      (pcd * bz + pbd * cz + pbc * dz) * alift + (pda * cz + pac * dz + pcd * az) * blift +
      (pab * dz + pbd * az + pda * bz) * clift + (pbc * az + pac * bz + pab * cz) * dlift;
  if (std::fabs(det) > kBound * permanent) return det > 0 ? -1 : 1;
  return exact_in_sphere(a, b, c, d, p);
}

}  // namespace remeshd::kernel
