#include "tests/campaign/verifier/mesh_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace remeshd::campaign {
namespace {

/// Smallest radius of curvature of a surface near p; infinite for planes.
double curvature_radius(const Surface& s, const Vec3& p) {
  switch (s.kind) {
    case Surface::Kind::Plane:
      return HUGE_VAL;
    case Surface::Kind::Cone: {
      const Vec3 d = p - Vec3{s.frame.m[3], s.frame.m[7], s.frame.m[11]};
      const double z = dot(d, {s.frame.m[2], s.frame.m[6], s.frame.m[10]});
      return std::fabs(s.r1 + s.r2 * z) * std::sqrt(1 + s.r2 * s.r2);
    }
    case Surface::Kind::Torus: {
      return std::min(s.r2, std::fabs(s.r1) > s.r2 ? std::fabs(s.r1) - s.r2 : s.r2);
    }
    default:
      return s.r1;
  }
}

/// How far a facet of this size may be from a surface of this radius: half a turn at most.
double chord_rise(double size, double radius) {
  if (radius == HUGE_VAL) return 0;
  if (size >= radius) return size;
  return radius - std::sqrt(radius * radius - size * size);
}

}  // namespace

double rise_over_intersection(const Surface& one, const Surface& other, const Vec3& a,
                              const Vec3& b) {
  constexpr int kSteps = 50;
  constexpr double kParallel = 1e-12;  // sine of the angle, squared
  constexpr double kEnough = 1e-9;     // of the chord
  const Vec3 middle = 0.5 * (a + b);
  const double chord = distance(a, b);
  Vec3 p = middle;
  for (int step = 0; step < kSteps && distance(p, middle) < chord; ++step) {
    // The least motion after which p is on both tangent planes.
    const double d1 = signed_distance(one, p), d2 = signed_distance(other, p);
    if (std::fabs(d1) + std::fabs(d2) <= kEnough * chord) return distance(p, middle);
    const Vec3 n1 = normal(one, p), n2 = normal(other, p);
    const double c = dot(n1, n2), s2 = norm2(cross(n1, n2));
    if (s2 < kParallel) return 0;
    p = p - ((d1 - c * d2) / s2) * n1 - ((d2 - c * d1) / s2) * n2;
  }
  return 0;
}

Vec3 nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  // Ericson 2005, section 5.1.5.
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
  const double w = 1 / (va + vb + vc);
  return a + (vb * w) * ab + (vc * w) * ac;
}

MeshSurface::MeshSurface(const TetMesh& mesh, const std::vector<Triangle>& facets,
                         const Membership& membership, double tiny)
    : mesh_(mesh), facets_(facets), tiny_(tiny) {
  find_surfaces(membership);
  measure_rises();
  measure_rim_rises();
  build_grid();
}

void MeshSurface::find_surfaces(const Membership& membership) {
  on_.resize(mesh_.nodes.size());
  std::vector<char> looked_at(mesh_.nodes.size(), 0);
  for (const Triangle& facet : facets_)
    for (const std::int32_t n : facet) {
      if (std::exchange(looked_at[n], 1) == 1) continue;
      const Vec3& p = mesh_.nodes[n];
      for (const Solid& solid : membership.solids()) {
        if (!solid.bounds().contains(p, tiny_)) continue;
        for (const SolidFace& face : solid.faces())
          if (std::fabs(signed_distance(face.surface, p)) <= tiny_) on_[n].push_back(&face.surface);
      }
    }
}

void MeshSurface::measure_rises() {
  // For each boundary node the smallest radius of curvature of the surfaces that it lies on.
  std::vector<double> radius(mesh_.nodes.size(), HUGE_VAL);
  for (std::size_t n = 0; n < on_.size(); ++n)
    for (const Surface* surface : on_[n])
      radius[n] = std::min(radius[n], curvature_radius(*surface, mesh_.nodes[n]));
  // A facet's own rise, from its edges; at each node that of the facets round it; and the facet's
  // allowance from its nodes.
  std::vector<double> round(mesh_.nodes.size(), 0);
  for (const Triangle& facet : facets_) {
    double longest = 0, least = 0;
    for (int i = 0; i < 3; ++i)
      longest = std::max(longest, distance(mesh_.nodes[facet[i]], mesh_.nodes[facet[(i + 1) % 3]]));
    // All three nodes lie on the face, so the widest of the nodes' radii bounds the face's from
    // above; at a node on an edge the other face's counts too, hence the largest.
    for (const std::int32_t n : facet) least = std::max(least, radius[n]);
    longest_ = std::max(longest_, longest);
    rise_.push_back(chord_rise(0.6 * longest, least));
    double any = HUGE_VAL;
    for (const std::int32_t n : facet) any = std::min(any, radius[n]);
    const double most = chord_rise(0.6 * longest, any);
    for (const std::int32_t n : facet) round[n] = std::max(round[n], most);
  }
  for (const Triangle& facet : facets_) {
    double most = 0;
    for (const std::int32_t n : facet) most = std::max(most, round[n]);
    allowed_.push_back(most + tiny_);
    most_allowed_ = std::max(most_allowed_, allowed_.back());
  }
}

void MeshSurface::measure_rim_rises() {
  for (const Triangle& facet : facets_) {
    double most = 0;
    for (int i = 0; i < 3; ++i) {
      const std::int32_t a = facet[i], b = facet[(i + 1) % 3];
      std::vector<const Surface*> both = on_[a];
      std::erase_if(both, [&](const Surface* s) { return std::ranges::count(on_[b], s) == 0; });
      for (std::size_t j = 0; j < both.size(); ++j)
        for (std::size_t k = 0; k < j; ++k)
          most = std::max(
              most, rise_over_intersection(*both[j], *both[k], mesh_.nodes[a], mesh_.nodes[b]));
    }
    rim_rise_.push_back(most);
  }
}

std::array<int, 3> MeshSurface::cell_of(const Vec3& p) const {
  const auto along = [&](double x, double lo, int n) {
    return std::clamp(static_cast<int>((x - lo) / cell_), 0, n - 1);
  };
  return {along(p.x, box_.lo.x, cells_[0]), along(p.y, box_.lo.y, cells_[1]),
          along(p.z, box_.lo.z, cells_[2])};
}

void MeshSurface::build_grid() {
  for (const Triangle& facet : facets_)
    for (const std::int32_t n : facet) box_.add(mesh_.nodes[n]);
  if (facets_.empty()) return;
  const Vec3 size = box_.hi - box_.lo;
  cell_ = std::max(box_.diagonal() / 60, 1e-300);
  cells_ = {1 + static_cast<int>(size.x / cell_), 1 + static_cast<int>(size.y / cell_),
            1 + static_cast<int>(size.z / cell_)};
  grid_.resize(static_cast<std::size_t>(cells_[0]) * cells_[1] * cells_[2]);
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    Box box;
    for (const std::int32_t n : facets_[f]) box.add(mesh_.nodes[n]);
    const auto lo = cell_of(box.lo), hi = cell_of(box.hi);
    for (int i = lo[0]; i <= hi[0]; ++i)
      for (int j = lo[1]; j <= hi[1]; ++j)
        for (int k = lo[2]; k <= hi[2]; ++k)
          grid_[(static_cast<std::size_t>(i) * cells_[1] + j) * cells_[2] + k].push_back(
              static_cast<std::int32_t>(f));
  }
}

MeshSurface::Nearest MeshSurface::measure(std::int32_t facet, const Vec3& p) const {
  const Triangle& t = facets_[facet];
  const Vec3 q = nearest_on_triangle(p, mesh_.nodes[t[0]], mesh_.nodes[t[1]], mesh_.nodes[t[2]]);
  return {distance(p, q), allowed_[facet], facet};
}

MeshSurface::Nearest MeshSurface::least_beyond(const Vec3& p, double slack, double far) const {
  Nearest best{HUGE_VAL, 0, -1};
  if (facets_.empty()) return best;
  const auto beyond = [&](const Nearest& n) { return n.distance - slack * n.allowed; };
  const auto middle = cell_of(p);
  const int most = std::max({cells_[0], cells_[1], cells_[2]});
  for (int ring = 0; ring <= most; ++ring) {
    // All of the earlier rings are nearer than this.
    const double reached = (ring - 1) * cell_;
    if (reached > far || reached - slack * most_allowed_ > beyond(best)) break;
    for (int i = std::max(0, middle[0] - ring); i <= std::min(cells_[0] - 1, middle[0] + ring); ++i)
      for (int j = std::max(0, middle[1] - ring); j <= std::min(cells_[1] - 1, middle[1] + ring);
           ++j)
        for (int k = std::max(0, middle[2] - ring); k <= std::min(cells_[2] - 1, middle[2] + ring);
             ++k) {
          if (std::max({std::abs(i - middle[0]), std::abs(j - middle[1]),
                        std::abs(k - middle[2])}) != ring)
            continue;
          for (const std::int32_t f :
               grid_[(static_cast<std::size_t>(i) * cells_[1] + j) * cells_[2] + k]) {
            const Nearest here = measure(f, p);
            if (beyond(here) < beyond(best)) best = here;
            if (beyond(best) <= 0) return best;
          }
        }
  }
  return best;
}

}  // namespace remeshd::campaign
