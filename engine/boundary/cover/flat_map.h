#pragma once

#include <array>
#include <optional>
#include <span>

#include "engine/base/surface.h"

namespace remeshd {

/// A map of a part of a surface to the plane, one to one, for triangulating there: near enough
/// conformal that Delaunay triangles come out well-shaped. What goes all the way round an axis
/// becomes a ring.
class FlatMap {
 public:
  /// A map for the part of the surface that these points lie on. Points joined by sides have to be
  /// less than a third of a turn apart. Returns nothing where the part goes round a torus both
  /// ways.
  static std::optional<FlatMap> of(const Surface& surface, std::span<const Vec3> points);

  /// Where a point of the part lies in the plane.
  [[nodiscard]] std::array<double, 2> operator()(const Vec3& p) const;

 private:
  enum class Shape { Plane, Sphere, Strip, Sector, Ring };
  /// An angle about the axis, rad, and a height: over the radius on a cylinder, the angle round the
  /// tube on a torus, the distance from the axis on a cone.
  struct Parameters {
    double angle, height;
  };

  FlatMap(const Surface& surface, Shape shape)
      : surface_(surface), to_local_(rigid_inverse(surface.frame)), shape_(shape) {}
  [[nodiscard]] Parameters parameters(const Vec3& p) const;
  bool fit(std::span<const Vec3> points);
  void fit_pole(std::span<const Vec3> points);
  void fit_ring(std::span<const Vec3> points);

  Surface surface_;
  Transform to_local_;
  Shape shape_;
  bool swapped_ = false;        ///< a torus whose ring goes round the tube: the angles swapped
  double cut_ = 0;              ///< angles begin here
  double height_cut_ = 0;       ///< of a torus, heights too
  double middle_ = 0;           ///< height whose circle has the radius 1
  double growth_ = 1;           ///< of a ring's radius with height; factor of a strip's heights
  std::array<Vec3, 3> pole_{};  ///< axes of a sphere: the last points to the pole left out
};

}  // namespace remeshd
