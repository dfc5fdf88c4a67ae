#include "engine/motion/node_motion.h"

#include <array>
#include <cmath>

namespace remeshd {
namespace {

struct MotionLimits {
  /// Sine of the angle below which normals are the same. At a larger angle the place where surfaces
  /// meet moves up to a thousand times as fast as they do.
  double same_normal = 1e-3;
  double same_speed = 1e-6;  ///< relative: speeds from differences of closed forms are that exact
};
constexpr MotionLimits kLimits;

}  // namespace

bool moves_along(const Vec3& motion, const SurfaceMotion& surface, double fastest) {
  return std::fabs(dot(motion, surface.normal) - surface.speed) <=
         kLimits.same_speed * std::fmax(fastest, std::fabs(surface.speed));
}

CommonMotion common_motion(std::span<const SurfaceMotion> surfaces) {
  double fastest = 0;
  for (const SurfaceMotion& s : surfaces) fastest = std::fmax(fastest, std::fabs(s.speed));
  CommonMotion out;
  std::array<Vec3, 3> axes;  // orthonormal: directions that are taken, and the speed along each
  std::array<double, 3> speeds{};
  int taken = 0;
  for (const SurfaceMotion& s : surfaces) {
    Vec3 rest = s.normal;
    double speed = s.speed;
    for (int k = 0; k < taken; ++k) {
      const double along = dot(axes[k], s.normal);
      rest = rest - along * axes[k];
      speed -= along * speeds[k];
    }
    const double sine = norm(rest);
    if (taken == 3 || sine < kLimits.same_normal) {
      if (std::fabs(speed) > kLimits.same_speed * fastest) out.defined = false;
      continue;
    }
    axes[taken] = rest / sine;
    speeds[taken] = speed / sine;
    ++taken;
  }
  for (int k = 0; k < taken; ++k) out.motion.required += speeds[k] * axes[k];
  if (taken == 1) out.motion.freedom = {Freedom::Kind::Plane, axes[0]};
  if (taken == 2) out.motion.freedom = {Freedom::Kind::Line, normalised(cross(axes[0], axes[1]))};
  if (taken == 3) out.motion.freedom = {Freedom::Kind::None, {}};
  return out;
}

}  // namespace remeshd
