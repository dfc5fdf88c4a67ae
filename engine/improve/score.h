#pragma once

#include "engine/improve/local_mesh.h"

namespace remeshd {

/// Least gain of a score or measure for which a change is worth while; it also bounds the number of
/// changes.
inline constexpr double kLeastGain = 1e-3;
/// Tets of this measure and below have infinite energy.
inline constexpr double kNearlyFlat = 0.05;

/// How near a tet comes to being good enough in its volume-length measure and in its smallest
/// dihedral angle: 1 where it just is, more where it is better, 0 or less where it is flat or
/// inverted.
class Score {
 public:
  /// The goals: least volume-length measure, and least dihedral angle in rad.
  Score(double least_measure, double least_angle);

  [[nodiscard]] double operator()(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const;
  /// Of a tet of the mesh, whose measure need not be computed again.
  [[nodiscard]] double operator()(const LocalMesh& mesh, std::int32_t t) const;

  /// A smooth penalty on the measure and the six dihedral angles, these by 1 - cosine: the sum of
  /// (goal / value)^(2^k). The larger k, the more the worst of them counts. Infinite where the tet
  /// is nearly flat or inverted.
  [[nodiscard]] double energy(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                              int k) const;

 private:
  [[nodiscard]] double with_measure(double measure, const Vec3& a, const Vec3& b, const Vec3& c,
                                    const Vec3& d) const;

  double least_measure_;
  double least_versine_;  ///< 1 - cosine of the least angle
};

}  // namespace remeshd
