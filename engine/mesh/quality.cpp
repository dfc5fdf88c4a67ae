#include "engine/mesh/quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/base/parallel.h"

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

constexpr std::size_t kBlock = 4096;
constexpr int kRanks = 1000;  // of measures, to find a percentile without sorting them all

int rank_of(float measure) {
  return static_cast<int>(std::clamp(measure * kRanks, 0.0F, kRanks - 1.0F));
}

}  // namespace

TetMeasure measure_tet(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto [highest, lowest] = extreme_cosines(a, b, c, d);
  const auto rounded = [](double cosine) {
    constexpr double kUnits = 32767;
    return static_cast<std::int16_t>(std::lround(std::clamp(cosine, -1.0, 1.0) * kUnits));
  };
  return {static_cast<float>(volume_length(a, b, c, d)), rounded(highest), rounded(lowest)};
}

Pages<TetMeasure> measure_tets(const Pages<Vec3>& nodes, const Pages<Tet>& tets, const Run& run) {
  std::vector<TetMeasure> measures(tets.size());
  in_blocks(tets.size(), kBlock, run, [&](std::size_t begin, std::size_t end) {
    run.poll();
    for (std::size_t k = begin; k < end; ++k) {
      const Tet& t = tets[k];
      measures[k] = measure_tet(nodes[t[0]], nodes[t[1]], nodes[t[2]], nodes[t[3]]);
    }
  });
  return Pages(measures);
}

Quality summarise(std::initializer_list<MeasuredTets> mesh, double volume) {
  Quality quality;
  // A tet of the mesh.
  struct Place {
    const MeasuredTets* part = nullptr;
    std::size_t tet = 0;
  };
  const auto each = [&](auto&& f) {
    for (const MeasuredTets& part : mesh) {
      std::size_t t = 0;
      for (std::size_t k = 0; k < part.measures.pages(); ++k)
        for (const TetMeasure& m : part.measures.page(k)) {
          if (part.left_out.empty() || part.left_out[t] == 0) f(part, t, m);
          ++t;
        }
    }
  };
  double sum = 0;
  std::size_t count = 0;
  float lowest = HUGE_VALF;
  Place worst;
  std::int16_t sharpest = std::numeric_limits<std::int16_t>::min();
  std::int16_t bluntest = std::numeric_limits<std::int16_t>::max();
  std::array<std::uint32_t, kRanks> ranks{};
  each([&](const MeasuredTets& part, std::size_t t, const TetMeasure& m) {
    sum += static_cast<double>(m.volume_length);
    ++count;
    ++ranks[rank_of(m.volume_length)];
    sharpest = std::max(sharpest, m.highest_cosine);
    bluntest = std::min(bluntest, m.lowest_cosine);
    if (m.volume_length < lowest) {
      lowest = m.volume_length;
      worst = {&part, t};
    }
  });
  if (count == 0) return quality;
  quality.volume = volume;
  quality.volume_length_mean = sum / static_cast<double>(count);
  constexpr int kRanksPerBin = kRanks / 20;
  for (int rank = 0; rank < kRanks; ++rank) quality.histogram[rank / kRanksPerBin] += ranks[rank];
  const auto of_corners = [](const Place& at, auto&& f) {
    const Pages<Vec3>& p = at.part->nodes;
    const Tet& t = at.part->tets[at.tet];
    return f(p[t[0]], p[t[1]], p[t[2]], p[t[3]]);
  };
  quality.volume_length_min = of_corners(worst, volume_length);
  // Nearest rank: the smallest measure that at least one percent of the tets do not exceed.
  std::size_t below = (count + 99) / 100 - 1;
  int rank = 0;
  while (ranks[rank] <= below) below -= ranks[rank++];
  std::vector<std::pair<float, Place>> candidates;
  double smallest = std::numbers::pi, largest = 0;  // angles
  each([&](const MeasuredTets& part, std::size_t t, const TetMeasure& m) {
    if (rank_of(m.volume_length) == rank) candidates.emplace_back(m.volume_length, Place{&part, t});
    if (m.highest_cosine < sharpest && m.lowest_cosine > bluntest) return;
    const auto angles = of_corners({&part, t}, dihedral_angles);
    smallest = std::min(smallest, std::ranges::min(angles));
    largest = std::max(largest, std::ranges::max(angles));
  });
  const auto at = candidates.begin() + static_cast<std::ptrdiff_t>(below);
  std::ranges::nth_element(candidates, at, {}, [](const auto& c) {
    return std::tuple(c.first, c.second.part, c.second.tet);
  });
  quality.volume_length_p01 = of_corners(at->second, volume_length);
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  quality.dihedral_min = smallest * kDegrees;
  quality.dihedral_max = largest * kDegrees;
  return quality;
}

Quality measure_quality(std::span<const Vec3> nodes, std::span<const Tet> tets, const Run& run) {
  double volume = 0;
  for (const Tet& t : tets)
    volume += tet_volume(nodes[t[0]], nodes[t[1]], nodes[t[2]], nodes[t[3]]);
  const Pages<Vec3> paged_nodes(nodes);
  const Pages<Tet> paged_tets(tets);
  const Pages<TetMeasure> measures = measure_tets(paged_nodes, paged_tets, run);
  return summarise({{paged_nodes, paged_tets, measures}}, volume);
}

}  // namespace remeshd
