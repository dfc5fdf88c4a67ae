#include "engine/boundary/lattice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/base/angle.h"

namespace remeshd {

namespace {

/// x spacing.
struct Margins {
  double of_rows = 2.5;   ///< round `box`: cylinders and cones have rows at radii found there
  double of_seen = 1e-6;  ///< round `within`: for rounding, on top of the jitter
};
constexpr Margins kMargins;

/// Of a sphere or torus with more rows only those that may be seen are visited, and each draws from
/// a random stream of its own. With fewer, all rows draw from one stream in turn.
constexpr std::int64_t kManyRows = 2000;

/// The random stream of a row.
Random of_row(std::uint64_t stream, std::int64_t row) {
  return Random(stream ^ (static_cast<std::uint64_t>(row + 1) * 0xD1B54A32D192ED03ULL));
}

struct Range {
  double lo = 0, hi = 0;

  [[nodiscard]] bool holds(double x) const { return x >= lo && x <= hi; }
  [[nodiscard]] Range shifted(double by) const { return {lo + by, hi + by}; }
};

/// The angles from the first axis at which a rectangle is seen from the origin: all of them where
/// it holds the origin.
Range angles_of(const Range& x, const Range& y) {
  if (x.holds(0) && y.holds(0)) return {0, kTurn};
  const double middle = std::atan2(y.lo + y.hi, x.lo + x.hi);
  const double c = std::cos(middle), s = std::sin(middle);
  Range seen{middle, middle};
  for (const double px : {x.lo, x.hi})
    for (const double py : {y.lo, y.hi}) {
      const double angle = middle + std::atan2(c * py - s * px, c * px + s * py);
      seen = {std::fmin(seen.lo, angle), std::fmax(seen.hi, angle)};
    }
  return seen;
}

/// The distances of a rectangle's points from the origin.
Range distances_of(const Range& x, const Range& y) {
  return {std::hypot(std::clamp(0.0, x.lo, x.hi), std::clamp(0.0, y.lo, y.hi)),
          std::hypot(std::fmax(-x.lo, x.hi), std::fmax(-y.lo, y.hi))};
}

struct Steps {
  std::int64_t begin = 0, end = 0;
};

/// Of `count` even steps round a turn those that may lie at some angles, each up to `jitter` / 2
/// steps from its place; as up to two ranges, ascending.
std::array<Steps, 2> steps_seen(const Range& angles, std::int64_t count, double phase,
                                double jitter) {
  const auto n = static_cast<double>(count);
  auto begin = static_cast<std::int64_t>(std::ceil(angles.lo / kTurn * n - phase - jitter / 2));
  auto end = static_cast<std::int64_t>(std::floor(angles.hi / kTurn * n - phase + jitter / 2)) + 1;
  if (angles.hi - angles.lo >= kTurn || end - begin >= count) return {{{0, count}}};
  const auto turns = static_cast<std::int64_t>(std::floor(static_cast<double>(begin) / n)) * count;
  begin -= turns;
  end -= turns;
  if (end <= count) return {{{begin, end}}};
  return {{{0, end - count}, {begin, count}}};
}

std::int64_t divisions(double length, double spacing) {
  return std::max<std::int64_t>(1, std::llround(length / spacing));
}

/// Calls row(place) at even steps over a range. The step is `spacing`, not fitted to the range, so
/// that all surfaces are covered with the same density.
template <class Row>
void visit_rows(const Range& range, double spacing, Random& random, Row&& row) {
  const double phase = random.uniform();
  const auto count = static_cast<std::int64_t>(std::ceil((range.hi - range.lo) / spacing)) + 1;
  for (std::int64_t k = 0; k < count; ++k)
    row(range.lo + (static_cast<double>(k + 1) - phase) * spacing);
}

class Lattice {
 public:
  Lattice(const Surface& surface, const Box& box, const Box& within, double spacing, double jitter,
          Random& random, const std::function<void(const Vec3&)>& visit)
      : surface_(surface),
        spacing_(spacing),
        jitter_(jitter),
        random_(random),
        visit_(visit),
        local_(moved(box, rigid_inverse(surface.frame))),
        rho_(distances_of(widened(local_.lo.x, local_.hi.x, kMargins.of_rows),
                          widened(local_.lo.y, local_.hi.y, kMargins.of_rows))) {
    const Box seen = moved(within, rigid_inverse(surface.frame));
    const double margin = 0.5 * jitter + kMargins.of_seen;
    const Range x = widened(seen.lo.x, seen.hi.x, margin);
    const Range y = widened(seen.lo.y, seen.hi.y, margin);
    seen_z_ = widened(seen.lo.z, seen.hi.z, margin);
    seen_rho_ = distances_of(x, y);
    seen_ = angles_of(x, y);
  }

  void visit() {
    switch (surface_.kind) {
      case Surface::Kind::Plane:
        return plane();
      case Surface::Kind::Cylinder:
        return cylinder(surface_.r1);
      case Surface::Kind::Cone:
        return cone(surface_.r1, surface_.r2);
      case Surface::Kind::Sphere:
        return sphere(surface_.r1);
      case Surface::Kind::Torus:
        return torus(surface_.r1, surface_.r2);
    }
  }

 private:
  [[nodiscard]] Range widened(double lo, double hi, double margin) const {
    return {lo - margin * spacing_, hi + margin * spacing_};
  }

  void plane() {
    const double width = local_.hi.x - local_.lo.x;
    visit_rows({local_.lo.y, local_.hi.y}, spacing_, random_, [&](double y) {
      row(divisions(width, spacing_), {0, kTurn},
          [&](double t, double wobble) { emit(local_.lo.x + t * width, y + wobble, 0); });
    });
  }

  void cylinder(double radius) {
    if (!rho_.holds(radius)) return;
    visit_rows({local_.lo.z, local_.hi.z}, spacing_, random_, [&](double z) {
      ring(radius, true, seen_,
           [&](double c, double s, double wobble) { emit(radius * c, radius * s, z + wobble); });
    });
  }

  void cone(double radius, double slope) {
    const double slant = std::sqrt(1 + slope * slope);
    // Only heights at which the cone has a radius that the box has: of a nearly flat cone these are
    // few of the box's heights.
    const Range width = widened(rho_.lo, rho_.hi, kMargins.of_rows);
    const double one = (width.lo - radius) / slope, other = (width.hi - radius) / slope;
    const Range height{std::fmax(local_.lo.z, std::fmin(one, other)),
                       std::fmin(local_.hi.z, std::fmax(one, other))};
    if (height.lo > height.hi) return;
    visit_rows({height.lo * slant, height.hi * slant}, spacing_, random_, [&](double s) {
      ring(std::fabs(radius + slope * s / slant), true, seen_,
           [&](double c, double sn, double wobble) {
             const double z = (s + wobble) / slant;
             const double r = radius + slope * z;
             if (r >= 0) emit(r * c, r * sn, z);
           });
    });
  }

  void sphere(double radius) {
    const Range angles = angles_of(seen_z_, seen_rho_);
    const auto row_at = [&](double s) {
      // The last row may lie beyond the pole, with its points on the other side of the axis.
      const double from_pole = std::numbers::pi - std::fabs(std::numbers::pi - s / radius);
      const bool seen = angles.holds(from_pole);
      const Range about = s > std::numbers::pi * radius ? Range{0, kTurn} : seen_;
      ring(std::fabs(radius * std::sin(s / radius)), seen, about,
           [&](double c, double sn, double wobble) {
             const double a = (s + wobble) / radius;
             emit(radius * std::sin(a) * c, radius * std::sin(a) * sn, radius * std::cos(a));
           });
    };
    const double half_turn = std::numbers::pi * radius;
    const auto rows = static_cast<std::int64_t>(std::ceil(half_turn / spacing_)) + 1;
    if (rows <= kManyRows) return visit_rows({0, half_turn}, spacing_, random_, row_at);
    const double phase = random_.uniform();
    const auto row_of = [&](double angle) { return angle * radius / spacing_ + phase - 1; };
    const auto first = static_cast<std::int64_t>(std::floor(row_of(angles.lo)));
    const auto last = static_cast<std::int64_t>(std::ceil(row_of(angles.hi)));
    visit_some(
        {{std::clamp<std::int64_t>(first, 0, rows), std::clamp<std::int64_t>(last + 1, 0, rows)}},
        [&](std::int64_t k) { row_at((static_cast<double>(k + 1) - phase) * spacing_); });
  }

  void torus(double major, double minor) {
    // Whole turns of the tube: the step is fitted so that the last row meets the first.
    const std::int64_t rows = divisions(kTurn * minor, spacing_);
    const double phase = random_.uniform();
    const auto seen =
        steps_seen(angles_of(seen_rho_.shifted(-major), seen_z_), rows, phase, jitter_);
    const auto row_at = [&](std::int64_t k, bool in) {
      const double a = kTurn * (static_cast<double>(k) + phase) / static_cast<double>(rows);
      ring(std::fabs(major + minor * std::cos(a)), in, seen_,
           [&](double c, double s, double wobble) {
             const double b = a + wobble / minor;
             const double r = major + minor * std::cos(b);
             if (r >= 0) emit(r * c, r * s, minor * std::sin(b));
           });
    };
    if (rows > kManyRows) return visit_some(seen, [&](std::int64_t k) { row_at(k, true); });
    for (std::int64_t k = 0; k < rows; ++k)
      row_at(k, std::ranges::any_of(
                    seen, [&](const Steps& steps) { return k >= steps.begin && k < steps.end; }));
  }

  /// Visits some of many rows, each with its own random stream.
  template <class Row>
  void visit_some(const std::array<Steps, 2>& rows, Row&& row) {
    const std::uint64_t stream = random_.next();
    for (const Steps& steps : rows)
      for (std::int64_t k = steps.begin; k < steps.end; ++k) {
        random_ = of_row(stream, k);
        row(k);
      }
    random_ = Random(stream);
  }

  /// A row round the axis: calls place(cosine, sine, wobble) for its points at `angles`. Where it
  /// is not `seen` its random numbers are skipped.
  template <class Place>
  void ring(double radius, bool seen, const Range& angles, Place&& place) {
    const std::int64_t count = divisions(kTurn * radius, spacing_);
    if (!seen) return random_.skip(draws_of_row(count));
    row(count, angles,
        [&](double t, double wobble) { place(std::cos(kTurn * t), std::sin(kTurn * t), wobble); });
  }

  /// One row of `count` jittered points: calls place(t, wobble) for those at `angles`. t runs from
  /// 0 to 1 over a turn, give or take the jitter. Each point draws the same numbers whichever
  /// others are visited.
  template <class Place>
  void row(std::int64_t count, const Range& angles, Place&& place) {
    const double phase = random_.uniform();
    const Random first = random_;
    random_.skip(draws_of_row(count) - 1);
    for (const Steps& steps : steps_seen(angles, count, phase, jitter_)) {
      Random draws = first;
      draws.skip(2 * static_cast<std::uint64_t>(steps.begin));
      for (std::int64_t k = steps.begin; k < steps.end; ++k) {
        const double along = jitter_ * draws.uniform(-0.5, 0.5);
        const double wobble = jitter_ * spacing_ * draws.uniform(-0.5, 0.5);
        place((static_cast<double>(k) + phase + along) / static_cast<double>(count), wobble);
      }
    }
  }

  static std::uint64_t draws_of_row(std::int64_t count) {
    return 1 + 2 * static_cast<std::uint64_t>(count);
  }

  void emit(double x, double y, double z) { visit_(surface_.frame.apply({x, y, z})); }

  const Surface& surface_;
  double spacing_, jitter_;
  Random& random_;
  const std::function<void(const Vec3&)>& visit_;
  Box local_;
  Range rho_;                ///< distances from the axis in the widened box
  Range seen_z_, seen_rho_;  ///< heights and distances from the axis in `within`, widened
  Range seen_;               ///< angles about the axis in `within`, widened
};

}  // namespace

void visit_lattice(const Surface& surface, const Box& box, const Box& within, double spacing,
                   double jitter, Random& random, const std::function<void(const Vec3&)>& visit) {
  Lattice(surface, box, within, spacing, jitter, random, visit).visit();
}

}  // namespace remeshd
