#include "engine/boundary/lattice.h"

#include <algorithm>
#include <numbers>

namespace remeshd {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

struct Range {
  double lo = 0, hi = 0;
};

/// The box in the surface's own frame.
Box local_box(const Surface& surface, const Box& box) {
  const Transform inverse = rigid_inverse(surface.frame);
  Box local;
  for (int k = 0; k < 8; ++k)
    local.add(inverse.apply({(k & 1) ? box.hi.x : box.lo.x, (k & 2) ? box.hi.y : box.lo.y,
                             (k & 4) ? box.hi.z : box.lo.z}));
  return local;
}

/// Jittered points of one row of `length`, `count` of them: calls point(t) with t in [0, 1).
template <class Point>
void visit_row(int count, double jitter, Random& random, Point&& point) {
  const double phase = random.uniform();
  for (int k = 0; k < count; ++k) point((k + phase + jitter * random.uniform(-0.5, 0.5)) / count);
}

int divisions(double length, double spacing) {
  return std::max(1, static_cast<int>(std::lround(length / spacing)));
}

/// Rows at even steps over a range; the step is kept so that the density is even.
template <class Row>
void visit_rows(Range range, double spacing, Random& random, Row&& row) {
  const double phase = random.uniform();
  const int count = static_cast<int>(std::ceil((range.hi - range.lo) / spacing)) + 1;
  for (int k = 0; k < count; ++k) row(range.lo + (k + 1 - phase) * spacing);
}

}  // namespace

void visit_lattice(const Surface& surface, const Box& box, double spacing, double jitter,
                   Random& random, const std::function<void(const Vec3&)>& visit) {
  const Box local = local_box(surface, box);
  const auto emit = [&](double x, double y, double z) { visit(surface.frame.apply({x, y, z})); };
  const auto wobble = [&] { return jitter * spacing * random.uniform(-0.5, 0.5); };
  const auto ring = [&](double radius, auto&& place) {
    visit_row(divisions(kTurn * radius, spacing), jitter, random,
              [&](double t) { place(std::cos(kTurn * t), std::sin(kTurn * t)); });
  };

  switch (surface.kind) {
    case Surface::Kind::Plane:
      visit_rows({local.lo.y, local.hi.y}, spacing, random, [&](double y) {
        const double width = local.hi.x - local.lo.x;
        visit_row(divisions(width, spacing), jitter, random,
                  [&](double t) { emit(local.lo.x + t * width, y + wobble(), 0); });
      });
      break;
    case Surface::Kind::Cylinder:
      visit_rows({local.lo.z, local.hi.z}, spacing, random, [&](double z) {
        ring(surface.r1,
             [&](double c, double s) { emit(surface.r1 * c, surface.r1 * s, z + wobble()); });
      });
      break;
    case Surface::Kind::Cone: {
      const double slant = std::sqrt(1 + surface.r2 * surface.r2);
      visit_rows({local.lo.z * slant, local.hi.z * slant}, spacing, random, [&](double s) {
        const double radius = std::fabs(surface.r1 + surface.r2 * s / slant);
        ring(radius, [&](double c, double sn) {
          const double z = (s + wobble()) / slant;
          const double r = surface.r1 + surface.r2 * z;
          emit(r * c, r * sn, z);
        });
      });
      break;
    }
    case Surface::Kind::Sphere: {
      const double r = surface.r1;
      visit_rows({0, std::numbers::pi * r}, spacing, random, [&](double s) {
        ring(std::fabs(r * std::sin(s / r)), [&](double c, double sn) {
          const double a = (s + wobble()) / r;
          emit(r * std::sin(a) * c, r * std::sin(a) * sn, r * std::cos(a));
        });
      });
      break;
    }
    case Surface::Kind::Torus: {
      // Whole turns of the tube: the step is fitted so that the last row meets the first.
      const int rows = divisions(kTurn * surface.r2, spacing);
      const double phase = random.uniform();
      for (int k = 0; k < rows; ++k) {
        const double a = kTurn * (k + phase) / rows;
        ring(std::fabs(surface.r1 + surface.r2 * std::cos(a)), [&](double c, double s) {
          const double b = a + wobble() / surface.r2;
          const double r = surface.r1 + surface.r2 * std::cos(b);
          emit(r * c, r * s, surface.r2 * std::sin(b));
        });
      }
      break;
    }
  }
}

}  // namespace remeshd
