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
  /// `angle`: about the axis, rad. `height`: on a cylinder z over the radius; on a torus the angle
  /// round the tube, rad; on a cone the distance from the axis, a length.
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
  bool swapped_ = false;   ///< a torus whose ring goes round the tube: the angles swapped
  double cut_ = 0;         ///< angles begin here
  double height_cut_ = 0;  ///< of a torus, heights too
  double middle_ = 0;      ///< of a ring: the height that is mapped to the circle of radius 1
  /// Of a ring: the growth g of the radius with the height h, which is exp(g (h - middle)), on a
  /// cone (h / middle)^g. Of a strip: the factor of its heights.
  double growth_ = 1;
  std::array<Vec3, 3> pole_{};  ///< of a sphere: axes; the last points to the centre of projection
};

}  // namespace remeshd
