#include "engine/model/placement.h"

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "engine/base/tolerance.h"
#include "engine/model/expression.h"
#include "engine/model/limits.h"

namespace remeshd {
namespace {

Vec3 evaluate_triple(const std::array<Scalar, 3>& triple, const Scope& scope,
                     const std::string& feature, const std::string& name) {
  std::array<double, 3> v{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string place = name + "[" + std::to_string(k) + "]";
    v[k] = checked_coordinate(scope.value(triple[k], feature, place), feature, place);
  }
  return {v[0], v[1], v[2]};
}

/// Unit vector along an axis; any length but zero will do.
Vec3 evaluate_axis(const std::array<Scalar, 3>& triple, const Scope& scope,
                   const std::string& feature, const std::string& name) {
  const Vec3 v = evaluate_triple(triple, scope, feature, name);
  const double largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  if (largest < kMinSize) throw error::degenerate_frame(feature, name, "is zero");
  return normalised(v / largest);
}

}  // namespace

Transform evaluate_placement(const PlacementSource& source, const Scope& scope,
                             const std::string& feature) {
  const Vec3 origin = evaluate_triple(source.origin, scope, feature, "placement.origin");
  Vec3 z{0, 0, 1};
  if (source.z_axis) z = evaluate_axis(*source.z_axis, scope, feature, "placement.zAxis");
  Vec3 x{1, 0, 0};
  if (source.x_axis) {
    x = evaluate_axis(*source.x_axis, scope, feature, "placement.xAxis");
    if (norm(cross(z, x)) <= tolerance::kSameDirection)
      throw error::degenerate_frame(feature, "placement.xAxis", "is parallel to zAxis");
  } else if (norm(cross(z, x)) <= tolerance::kSameDirection) {
    x = {0, 1, 0};
  }
  Vec3 y = normalised(cross(z, x));
  // Nearly parallel axes leave y with few digits: a second pass makes it perpendicular again.
  y = normalised(y - dot(y, z) * z);
  return Transform::frame(cross(y, z), y, z, origin);
}

}  // namespace remeshd
