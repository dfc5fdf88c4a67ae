#include "engine/cellular/cell_samples.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace remeshd {
namespace {

struct Facet {
  Vec3 a, b, c;
  Vec3 normal;  ///< out of the cell, as long as twice the area
};

std::vector<Facet> facets_of(const kernel::Brep& brep, int cell) {
  std::vector<Facet> facets;
  for (const int f : brep.cells[cell].faces)
    for (const auto& [i, j, k] : brep.faces[f].triangles) {
      const Vec3 a = brep.points[i], b = brep.points[j], c = brep.points[k];
      const Vec3 n = cross(b - a, c - a);
      facets.push_back({a, b, c, brep.faces[f].cells[0] == cell ? n : -n});
    }
  std::stable_sort(facets.begin(), facets.end(), [](const Facet& l, const Facet& r) {
    return norm2(l.normal) > norm2(r.normal);
  });
  return facets;
}

/// Where the ray from p along d meets the facet, as a multiple of d; infinite if it does not.
double hit(const Facet& facet, const Vec3& p, const Vec3& d) {
  const Vec3 ab = facet.b - facet.a, ac = facet.c - facet.a, ap = p - facet.a;
  const Vec3 dac = cross(d, ac);
  const double det = dot(ab, dac);
  if (det == 0) return HUGE_VAL;
  const double u = dot(ap, dac) / det;
  const Vec3 q = cross(ap, ab);
  const double v = dot(d, q) / det;
  if (u < 0 || v < 0 || u + v > 1) return HUGE_VAL;
  const double t = dot(ac, q) / det;
  return t > 0 ? t : HUGE_VAL;
}

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  const double t = norm2(d) > 0 ? std::clamp(dot(p - a, d) / norm2(d), 0.0, 1.0) : 0.0;
  return distance(p, a + t * d);
}

double distance_to(const Facet& facet, const Vec3& p) {
  const Vec3 n = facet.normal;
  const double h = dot(p - facet.a, n) / norm(n);
  const Vec3 q = p - (h / norm(n)) * n;
  const bool above =
      dot(cross(facet.b - facet.a, q - facet.a), cross(facet.b - facet.a, facet.c - facet.a)) >=
          0 &&
      dot(cross(facet.c - facet.b, q - facet.b), cross(facet.c - facet.b, facet.a - facet.b)) >=
          0 &&
      dot(cross(facet.a - facet.c, q - facet.c), cross(facet.a - facet.c, facet.b - facet.c)) >= 0;
  if (above) return std::fabs(h);
  return std::min({distance_to_segment(p, facet.a, facet.b),
                   distance_to_segment(p, facet.b, facet.c),
                   distance_to_segment(p, facet.c, facet.a)});
}

}  // namespace

std::vector<CellSample> sample_cell(const kernel::Brep& brep, int cell, int count) {
  const std::vector<Facet> facets = facets_of(brep, cell);
  std::vector<CellSample> samples;
  for (const Facet& facet : facets) {
    if (static_cast<int>(samples.size()) == count || norm2(facet.normal) == 0) break;
    // Off the centroid: rays through symmetric models would meet edges.
    const Vec3 p = 0.36 * facet.a + 0.33 * facet.b + 0.31 * facet.c;
    const Vec3 d = -normalised(facet.normal);
    double t = HUGE_VAL;
    for (const Facet& other : facets)
      if (&other != &facet) t = std::min(t, hit(other, p, d));
    if (!std::isfinite(t)) continue;
    CellSample sample{p + 0.5 * t * d, HUGE_VAL, p, p + t * d};
    for (const Facet& other : facets)
      if (norm2(other.normal) > 0)
        sample.depth = std::min(sample.depth, distance_to(other, sample.point));
    samples.push_back(sample);
  }
  std::stable_sort(samples.begin(), samples.end(),
                   [](const CellSample& l, const CellSample& r) { return l.depth > r.depth; });
  return samples;
}

double winding_number(const kernel::Brep& brep, int cell, const Vec3& p) {
  double angle = 0;
  for (const Facet& facet : facets_of(brep, cell)) {
    // Van Oosterom & Strackee 1983. The facet's corners may turn either way, its normal tells.
    const Vec3 a = facet.a - p, b = facet.b - p, c = facet.c - p;
    const double la = norm(a), lb = norm(b), lc = norm(c);
    const double turned =
        dot(cross(facet.b - facet.a, facet.c - facet.a), facet.normal) < 0 ? -1 : 1;
    angle += turned * 2 *
             std::atan2(dot(a, cross(b, c)),
                        la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return angle / (4 * std::numbers::pi);
}

}  // namespace remeshd
