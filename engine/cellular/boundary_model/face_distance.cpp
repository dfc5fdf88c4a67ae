#include "engine/cellular/boundary_model/face_distance.h"

#include <cmath>

namespace remeshd {

Vec3 nearest_on_triangle(const Vec3& p, const std::array<Vec3, 3>& corners) {
  const auto& [a, b, c] = corners;
  // Ericson 2005, 5.1.5.
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const Vec3 bp = p - b;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + (d1 / (d1 - d3)) * ab;
  const Vec3 cp = p - c;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + (d2 / (d2 - d6)) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b);
  const double s = 1.0 / (va + vb + vc);
  return a + (vb * s) * ab + (vc * s) * ac;
}

double triangle_distance2(const Vec3& p, const std::array<Vec3, 3>& corners) {
  return norm2(p - nearest_on_triangle(p, corners));
}

double face_distance2(const BoundaryFace& face, const Vec3& p) {
  double best = HUGE_VAL;
  for (const auto& t : face.triangles)
    best = std::fmin(
        best, triangle_distance2(p, {face.points[t[0]], face.points[t[1]], face.points[t[2]]}));
  return best;
}

}  // namespace remeshd
