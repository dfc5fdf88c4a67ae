#include "engine/mesh/quality.h"

#include <algorithm>
#include <numbers>
#include <utility>
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

constexpr int kRanks = 1000;  // of measures, to find a percentile without sorting them all

int rank_of(float measure) {
  return static_cast<int>(std::clamp(measure * kRanks, 0.0F, kRanks - 1.0F));
}

}  // namespace

TetMeasure measure_tet(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto [highest, lowest] = extreme_cosines(a, b, c, d);
  return {static_cast<float>(volume_length(a, b, c, d)), static_cast<float>(highest),
          static_cast<float>(lowest)};
}

std::vector<TetMeasure> measure_tets(std::span<const Vec3> nodes, std::span<const Tet> tets,
                                     const Run& run) {
  std::vector<TetMeasure> measures;
  measures.reserve(tets.size());
  Polling poll(run);
  for (const Tet& t : tets) {
    poll();
    measures.push_back(measure_tet(nodes[t[0]], nodes[t[1]], nodes[t[2]], nodes[t[3]]));
  }
  return measures;
}

Quality summarise(std::span<const TetMeasure> measures, std::span<const Vec3> nodes,
                  std::span<const Tet> tets, double volume) {
  Quality quality;
  if (measures.empty()) return quality;
  quality.volume = volume;
  double sum = 0;
  std::size_t sharpest = 0, bluntest = 0, worst = 0;
  std::vector<std::uint32_t> ranks(kRanks, 0);
  for (std::size_t t = 0; t < measures.size(); ++t) {
    const TetMeasure& m = measures[t];
    sum += static_cast<double>(m.volume_length);
    ++quality.histogram[static_cast<int>(std::clamp(m.volume_length * 20.0F, 0.0F, 19.0F))];
    ++ranks[rank_of(m.volume_length)];
    if (m.volume_length < measures[worst].volume_length) worst = t;
    if (m.highest_cosine > measures[sharpest].highest_cosine) sharpest = t;
    if (m.lowest_cosine < measures[bluntest].lowest_cosine) bluntest = t;
  }
  quality.volume_length_mean = sum / static_cast<double>(measures.size());
  const auto exact = [&](std::size_t tet) {
    const Tet& t = tets[tet];
    return volume_length(nodes[t[0]], nodes[t[1]], nodes[t[2]], nodes[t[3]]);
  };
  quality.volume_length_min = exact(worst);
  // Nearest rank: the smallest measure that at least one percent of the tets do not exceed.
  std::size_t below = (measures.size() + 99) / 100 - 1;
  int rank = 0;
  while (ranks[rank] <= below) below -= ranks[rank++];
  std::vector<std::pair<float, std::size_t>> candidates;
  for (std::size_t t = 0; t < measures.size(); ++t)
    if (rank_of(measures[t].volume_length) == rank)
      candidates.emplace_back(measures[t].volume_length, t);
  const auto at = candidates.begin() + static_cast<std::ptrdiff_t>(below);
  std::nth_element(candidates.begin(), at, candidates.end());
  quality.volume_length_p01 = exact(at->second);
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  const auto angles = [&](std::size_t tet) {
    const Tet& t = tets[tet];
    return dihedral_angles(nodes[t[0]], nodes[t[1]], nodes[t[2]], nodes[t[3]]);
  };
  quality.dihedral_min = std::ranges::min(angles(sharpest)) * kDegrees;
  quality.dihedral_max = std::ranges::max(angles(bluntest)) * kDegrees;
  return quality;
}

Quality measure_quality(std::span<const Vec3> nodes, std::span<const Tet> tets, const Run& run) {
  double volume = 0;
  for (const Tet& t : tets)
    volume += tet_volume(nodes[t[0]], nodes[t[1]], nodes[t[2]], nodes[t[3]]);
  return summarise(measure_tets(nodes, tets, run), nodes, tets, volume);
}

}  // namespace remeshd
