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

}  // namespace remeshd::kernel
