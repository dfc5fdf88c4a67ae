#include "engine/improve/score.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/mesh/quality.h"

namespace remeshd {
namespace {

/// Tets of this measure and above have no dihedral angle below any sensible goal.
constexpr double kNeverSharp = 0.7;

/// 1 - cosine of the six dihedral angles of a positive tet.
std::array<double, 6> versines(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const std::array<Vec3, 4> normal{cross(c - b, d - b), cross(d - a, c - a), cross(b - a, d - a),
                                   cross(c - a, b - a)};
  std::array<double, 4> scale{};
  for (int i = 0; i < 4; ++i) scale[i] = 1 / norm(normal[i]);
  std::array<double, 6> out{};
  int k = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) out[k++] = 1 + dot(normal[i], normal[j]) * scale[i] * scale[j];
  return out;
}

double squared(double x, int times) {
  for (int i = 0; i < times; ++i) x *= x;
  return x;
}

}  // namespace

Score::Score(double least_measure, double least_angle)
    : least_measure_(least_measure), least_versine_(1 - std::cos(least_angle)) {}

double Score::with_measure(double measure, const Vec3& a, const Vec3& b, const Vec3& c,
                           const Vec3& d) const {
  const double score = measure / least_measure_;
  if (!(measure > 0) || measure >= kNeverSharp) return score;
  const auto v = versines(a, b, c, d);
  return std::min(score, *std::min_element(v.begin(), v.end()) / least_versine_);
}

double Score::operator()(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const {
  return with_measure(volume_length(a, b, c, d), a, b, c, d);
}

double Score::operator()(const LocalMesh& mesh, std::int32_t t) const {
  const Tet& tet = mesh.tet(t);
  return with_measure(mesh.quality(t), mesh.node(tet[0]), mesh.node(tet[1]), mesh.node(tet[2]),
                      mesh.node(tet[3]));
}

double Score::energy(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, int k) const {
  const double measure = volume_length(a, b, c, d);
  if (!(measure > kNearlyFlat)) return HUGE_VAL;
  double sum = squared(least_measure_ / measure, k);
  for (const double v : versines(a, b, c, d)) sum += squared(least_versine_ / v, k);
  return sum;
}

}  // namespace remeshd
