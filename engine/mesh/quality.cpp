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

/// Cosines of the smallest and the largest dihedral angle: they order the angles without an inverse
/// function for each.
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

constexpr int kRanks = 1000;  // bins of volume-length, to find a percentile without sorting all

int rank_of(float measure) {
  return static_cast<int>(std::clamp(measure * kRanks, 0.0F, kRanks - 1.0F));
}

/// A tet of a mesh.
struct Place {
  const MeasuredTets* part = nullptr;
  std::size_t tet = 0;

  [[nodiscard]] double measure() const { return volume_length(part->nodes, part->tets[tet]); }
};

/// Sums and extremes of measures.
struct Tally {
  double sum = 0;
  std::size_t count = 0;
  float lowest = HUGE_VALF;
  Place worst;
  std::int16_t sharpest = std::numeric_limits<std::int16_t>::min();
  std::int16_t bluntest = std::numeric_limits<std::int16_t>::max();
  std::array<std::uint32_t, kRanks> ranks{};

  void add(const Place& at, const TetMeasure& m) {
    sum += static_cast<double>(m.volume_length);
    ++count;
    ++ranks[rank_of(m.volume_length)];
    sharpest = std::max(sharpest, m.highest_cosine);
    bluntest = std::min(bluntest, m.lowest_cosine);
    if (m.volume_length < lowest) {
      lowest = m.volume_length;
      worst = at;
    }
  }
  friend Tally operator+(Tally a, const Tally& b) {
    a.sum += b.sum;
    a.count += b.count;
    a.sharpest = std::max(a.sharpest, b.sharpest);
    a.bluntest = std::min(a.bluntest, b.bluntest);
    if (b.lowest < a.lowest) {
      a.lowest = b.lowest;
      a.worst = b.worst;
    }
    for (std::size_t rank = 0; rank < a.ranks.size(); ++rank) a.ranks[rank] += b.ranks[rank];
    return a;
  }
};

/// What a Tally leaves open and a second look at the tets finds: the exact extreme angles, and the
/// first percentile.
class Finder {
 public:
  explicit Finder(const Tally& tally) : tally_(tally), below_((tally.count + 99) / 100 - 1) {
    if (tally.count == 0) return;
    // Nearest rank: the smallest measure that at least one percent of the tets do not exceed.
    while (tally.ranks[rank_] <= below_) below_ -= tally.ranks[rank_++];
    // Bounds somewhat wider than the rank: cheaper to compare with than to compute ranks.
    low_ = rank_ == 0 ? -HUGE_VALF : (static_cast<float>(rank_) - 0.5F) / kRanks;
    high_ = rank_ == kRanks - 1 ? HUGE_VALF : (static_cast<float>(rank_) + 1.5F) / kRanks;
  }
  void look_at(const Place& at, const TetMeasure& m) {
    if (m.volume_length > low_ && m.volume_length < high_ && rank_of(m.volume_length) == rank_)
      candidates_.emplace_back(m.volume_length, at);
    if (m.highest_cosine < tally_.sharpest && m.lowest_cosine > tally_.bluntest) return;
    const auto angles = dihedral_angles(at.part->nodes, at.part->tets[at.tet]);
    smallest_ = std::min(smallest_, std::ranges::min(angles));
    largest_ = std::max(largest_, std::ranges::max(angles));
  }
  /// Pre: all tets of the tally have been looked at.
  Quality quality(double volume) {
    Quality quality;
    if (tally_.count == 0) return quality;
    quality.volume = volume;
    quality.volume_length_mean = tally_.sum / static_cast<double>(tally_.count);
    quality.volume_length_min = tally_.worst.measure();
    constexpr int kRanksPerBin = kRanks / 20;
    for (int rank = 0; rank < kRanks; ++rank)
      quality.histogram[rank / kRanksPerBin] += tally_.ranks[rank];
    const auto at = candidates_.begin() + static_cast<std::ptrdiff_t>(below_);
    std::ranges::nth_element(candidates_, at, {}, [](const auto& c) {
      return std::tuple(c.first, c.second.part, c.second.tet);
    });
    quality.volume_length_p01 = at->second.measure();
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    quality.dihedral_min = smallest_ * kDegrees;
    quality.dihedral_max = largest_ * kDegrees;
    return quality;
  }

 private:
  const Tally& tally_;
  int rank_ = 0;
  std::size_t below_;  ///< of the tets of this rank, how many are below the percentile
  float low_ = 0, high_ = 0;
  std::vector<std::pair<float, Place>> candidates_;
  double smallest_ = std::numbers::pi, largest_ = 0;  ///< angles
};

/// Calls f(place, measure, whether it is left out) for all tets.
template <class F>
void for_each_measure(const MeasuredTets& tets, F&& f) {
  tets.measures.for_each([&](std::size_t t, const TetMeasure& m) {
    f(Place{&tets, t}, m, !tets.left_out.empty() && tets.left_out[t] != 0);
  });
}

}  // namespace

TetMeasure measure_tet(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto [highest, lowest] = extreme_cosines(a, b, c, d);
  const auto rounded = [](double cosine) {
    constexpr double kUnits = std::numeric_limits<std::int16_t>::max();
    return static_cast<std::int16_t>(std::lround(std::clamp(cosine, -1.0, 1.0) * kUnits));
  };
  return {static_cast<float>(volume_length(a, b, c, d)), rounded(highest), rounded(lowest)};
}

CowVector<TetMeasure> measure_tets(const CowVector<Vec3>& nodes, const CowVector<Tet>& tets,
                                   const Run& run) {
  std::vector<TetMeasure> measures(tets.size());
  in_blocks(tets.size(), kCheapBlock, run, [&](std::size_t begin, std::size_t end) {
    run.poll();
    for (std::size_t k = begin; k < end; ++k) {
      const Tet& t = tets[k];
      measures[k] = measure_tet(nodes[t[0]], nodes[t[1]], nodes[t[2]], nodes[t[3]]);
    }
  });
  return CowVector(measures);
}

TwoQualities summarise_both(const MeasuredTets& first, double first_volume,
                            const MeasuredTets& instead, double second_volume) {
  Tally of_both, of_first, of_second;
  for_each_measure(first, [&](const Place& at, const TetMeasure& m, bool left_out) {
    (left_out ? of_first : of_both).add(at, m);
  });
  for_each_measure(instead,
                   [&](const Place& at, const TetMeasure& m, bool) { of_second.add(at, m); });
  const Tally all_first = of_both + of_first, all_second = of_both + of_second;
  Finder in_first(all_first), in_second(all_second);
  for_each_measure(first, [&](const Place& at, const TetMeasure& m, bool left_out) {
    in_first.look_at(at, m);
    if (!left_out) in_second.look_at(at, m);
  });
  for_each_measure(instead,
                   [&](const Place& at, const TetMeasure& m, bool) { in_second.look_at(at, m); });
  return {in_first.quality(first_volume), in_second.quality(second_volume)};
}

Quality summarise(const MeasuredTets& tets, double volume) {
  Tally tally;
  const auto each = [&](auto&& f) {
    for_each_measure(tets, [&](const Place& at, const TetMeasure& m, bool left_out) {
      if (!left_out) f(at, m);
    });
  };
  each([&](const Place& at, const TetMeasure& m) { tally.add(at, m); });
  Finder finder(tally);
  each([&](const Place& at, const TetMeasure& m) { finder.look_at(at, m); });
  return finder.quality(volume);
}

Quality measure_quality(std::span<const Vec3> nodes, std::span<const Tet> tets, const Run& run) {
  double volume = 0;
  for (const Tet& t : tets) volume += tet_volume(nodes, t);
  const CowVector<Vec3> paged_nodes(nodes);
  const CowVector<Tet> paged_tets(tets);
  const CowVector<TetMeasure> measures = measure_tets(paged_nodes, paged_tets, run);
  return summarise({paged_nodes, paged_tets, measures}, volume);
}

}  // namespace remeshd
