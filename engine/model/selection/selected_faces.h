#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "engine/base/vec.h"
#include "engine/model/expression.h"

namespace remeshd {

/// The variables of a selector's condition: a point of a face and the unit normal there, out of the
/// material; for a point in the material the normal is 0.
inline constexpr std::array kPlaceNames{"x", "y", "z", "nx", "ny", "nz"};

/// Faces of one feature that a selector names, where its condition holds.
struct SelectedFaces {
  int feature = -1;                ///< index in history
  std::vector<std::string> faces;  ///< as `faces_of` names them, each once
  bool whole = false;              ///< the feature itself is named, so its material is selected too
  OpenExpression condition;        ///< over `kPlaceNames`; an empty text holds everywhere
  friend bool operator==(const SelectedFaces&, const SelectedFaces&) = default;
};

/// Tells where a condition holds: where its value is a number other than 0. Not safe from several
/// threads.
class ConditionTest {
 public:
  explicit ConditionTest(const OpenExpression& condition)
      : value_(condition, kPlaceNames), margin_(condition, kPlaceNames, OpenValue::Kind::Margin) {}
  bool operator()(const Vec3& p, const Vec3& normal) {
    const double value = value_(std::array{p.x, p.y, p.z, normal.x, normal.y, normal.z});
    return value != 0 && std::isfinite(value);
  }
  /// By how much the comparisons in it hold or fail, in their own units: it goes to 0 towards the
  /// border of the part where the condition holds. NaN where that cannot be told.
  double margin(const Vec3& p, const Vec3& normal) {
    return margin_(std::array{p.x, p.y, p.z, normal.x, normal.y, normal.z});
  }

 private:
  OpenValue value_, margin_;
};

}  // namespace remeshd
