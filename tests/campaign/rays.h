#pragma once

#include <utility>
#include <vector>

#include "engine/base/surface.h"
#include "engine/model/solid.h"

namespace remeshd::campaign {

/// Exact intersections of lines with a model's boundary, from its features' closed formulas alone:
/// crossings with every untrimmed surface, then membership between them.
class Rays {
 public:
  /// Keeps a reference.
  explicit Rays(const Membership& membership);

  /// The stretches of p + t d, t in [from, to], that lie in material, ascending. `d` of unit
  /// length.
  [[nodiscard]] std::vector<std::pair<double, double>> material(const Vec3& p, const Vec3& d,
                                                                double from, double to) const;
  /// The first t in (from, to] at which the nature changes; `to` where it does not.
  [[nodiscard]] double first_change(const Vec3& p, const Vec3& d, double from, double to) const;

  /// Whether the nature changes within `reach` of p, by lines in 200 directions.
  [[nodiscard]] bool boundary_within(const Vec3& p, double reach) const;

  [[nodiscard]] const Membership& membership() const { return membership_; }

 private:
  void crossings(const Vec3& p, const Vec3& d, double from, double to,
                 std::vector<double>& out) const;

  const Membership& membership_;
  double same_;  ///< crossings nearer to each other are one
};

/// The k-th of n directions that a spiral spreads evenly over the sphere.
Vec3 spiral_direction(int k, int n);

/// The t at which p + t d meets the untrimmed surface; appended, in no order.
void intersect(const Surface& surface, const Vec3& p, const Vec3& d, std::vector<double>& out);

}  // namespace remeshd::campaign
