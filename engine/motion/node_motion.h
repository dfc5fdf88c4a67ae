#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/base/vec.h"

namespace remeshd {

/// Along what a node may slide without leaving what it stands on.
struct Freedom {
  enum class Kind : std::uint8_t { None, Line, Plane, Space };
  Kind kind = Kind::Space;
  Vec3 axis;  ///< unit: along the line; normal to the plane
  friend bool operator==(const Freedom&, const Freedom&) = default;

  /// The part of a vector that is free.
  Vec3 operator()(const Vec3& v) const {
    switch (kind) {
      case Kind::None:
        return {};
      case Kind::Line:
        return dot(axis, v) * axis;
      case Kind::Plane:
        return v - dot(axis, v) * axis;
      case Kind::Space:
        break;
    }
    return v;
  }
};

/// The displacements, or the velocities, that a node may have: `required` plus any vector that is
/// within `freedom`.
struct NodeMotion {
  Vec3 required;
  Freedom freedom;
};

/// The displacement, or the velocity, of a node that is where its surfaces are nearest to a point,
/// as a function of that of the point.
struct FollowingMotion {
  Vec3 required;                 ///< of the node while the point stays
  std::array<Vec3, 3> of_point;  ///< of the node for unit motions of the point along x, y and z

  Vec3 operator()(const Vec3& v) const {
    return required + v.x * of_point[0] + v.y * of_point[1] + v.z * of_point[2];
  }
  /// From d J / d motion of the node to d J / d motion of the point.
  [[nodiscard]] Vec3 reverse(const Vec3& seed) const {
    return {dot(of_point[0], seed), dot(of_point[1], seed), dot(of_point[2], seed)};
  }
};

/// How a surface moves at one of its points.
struct SurfaceMotion {
  Vec3 normal;       ///< unit
  double speed = 0;  ///< along the normal: length per unit of the parameter, or a displacement
};

/// What a node does that stays on several moving surfaces.
struct CommonMotion {
  NodeMotion motion;
  /// False where no motion keeps the node on all of the surfaces. `motion` then follows the first
  /// of them with independent normals, at most three, and ignores the others.
  bool defined = true;
};

/// Whether a point with this motion stays on a moving surface, to first order. The tolerance is
/// relative to `fastest`, a speed, or to the surface's own speed where that is greater.
bool moves_along(const Vec3& motion, const SurfaceMotion& surface, double fastest);

/// The motions that a node may have that stands where these surfaces meet.
CommonMotion common_motion(std::span<const SurfaceMotion> surfaces);

}  // namespace remeshd
