#include "engine/mesh/quality.h"

#include <algorithm>
#include <numbers>
#include <vector>

namespace remeshd {

double tet_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return dot(cross(b - a, c - a), d - a) / 6.0;
}

double volume_length(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 ad = d - a;
  const double six_volumes = dot(cross(ab, ac), ad);
  const double mean_square =
      (norm2(ab) + norm2(ac) + norm2(ad) + norm2(c - b) + norm2(d - b) + norm2(d - c)) / 6.0;
  if (!(mean_square > 0)) return 0;
  return std::numbers::sqrt2 * six_volumes / (mean_square * std::sqrt(mean_square));
}

std::array<double, 6> dihedral_angles(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const std::array<const Vec3*, 4> corner{&a, &b, &c, &d};
  std::array<Vec3, 4> outward;
  for (int i = 0; i < 4; ++i) {
    const Vec3& p = *corner[kTetFacets[i][0]];
    outward[i] = cross(*corner[kTetFacets[i][1]] - p, *corner[kTetFacets[i][2]] - p);
  }
  // The edge ij lies in the two facets opposite the other corners, k and l. atan2 keeps its
  // precision near 0 and 180 degrees, where an arc cosine loses half of its digits.
  constexpr std::array<std::array<int, 2>, 6> kOppositeFacets{
      {{2, 3}, {1, 3}, {1, 2}, {0, 3}, {0, 2}, {0, 1}}};
  std::array<double, 6> angles{};
  for (int e = 0; e < 6; ++e) {
    const Vec3& m = outward[kOppositeFacets[e][0]];
    const Vec3& n = outward[kOppositeFacets[e][1]];
    angles[e] = std::atan2(norm(cross(m, n)), -dot(m, n));
  }
  return angles;
}

namespace {

/// Cosines of the smallest and the largest dihedral angle: what orders angles without a call per
/// angle.
std::array<double, 2> extreme_cosines(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const std::array<Vec3, 4> outward{cross(c - b, d - b), cross(d - a, c - a), cross(b - a, d - a),
                                    cross(c - a, b - a)};
  std::array<double, 4> scale{};
  for (int i = 0; i < 4; ++i) scale[i] = 1 / norm(outward[i]);
  double highest = -1;
  double lowest = 1;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) {
      const double cosine = -dot(outward[i], outward[j]) * scale[i] * scale[j];
      highest = std::max(highest, cosine);
      lowest = std::min(lowest, cosine);
    }
  return {highest, lowest};
}

}  // namespace

Quality measure_quality(std::span<const Vec3> nodes, std::span<const Tet> tets, const Run& run) {
  Quality quality;
  if (tets.empty()) return quality;
  std::vector<double> measures;
  measures.reserve(tets.size());
  double highest_cosine = -HUGE_VAL;
  double lowest_cosine = HUGE_VAL;
  Tet sharpest = tets[0];
  Tet bluntest = tets[0];
  double sum = 0;
  Polling poll(run);
  for (const Tet& tet : tets) {
    poll();
    const Vec3& a = nodes[tet[0]];
    const Vec3& b = nodes[tet[1]];
    const Vec3& c = nodes[tet[2]];
    const Vec3& d = nodes[tet[3]];
    const double measure = volume_length(a, b, c, d);
    measures.push_back(measure);
    sum += measure;
    quality.volume += tet_volume(a, b, c, d);
    const auto bin = static_cast<int>(std::clamp(measure * 20.0, 0.0, 19.0));
    ++quality.histogram[bin];
    const auto [highest, lowest] = extreme_cosines(a, b, c, d);
    if (highest > highest_cosine) {
      highest_cosine = highest;
      sharpest = tet;
    }
    if (lowest < lowest_cosine) {
      lowest_cosine = lowest;
      bluntest = tet;
    }
  }
  quality.volume_length_mean = sum / static_cast<double>(measures.size());
  // Nearest rank: the smallest measure that at least one percent of the tets do not exceed.
  const std::size_t rank = (measures.size() + 99) / 100 - 1;
  std::nth_element(measures.begin(), measures.begin() + static_cast<std::ptrdiff_t>(rank),
                   measures.end());
  quality.volume_length_p01 = measures[rank];
  quality.volume_length_min = *std::min_element(measures.begin(), measures.end());
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  const auto angles = [&](const Tet& t) {
    return dihedral_angles(nodes[t[0]], nodes[t[1]], nodes[t[2]], nodes[t[3]]);
  };
  quality.dihedral_min = std::ranges::min(angles(sharpest)) * kDegrees;
  quality.dihedral_max = std::ranges::max(angles(bluntest)) * kDegrees;
  return quality;
}

}  // namespace remeshd
