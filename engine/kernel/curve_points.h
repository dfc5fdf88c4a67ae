#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/base/vec.h"

namespace remeshd::kernel {

/// rad: at most between points of an edge, 6 degrees are promised, and between the chords of a
/// circle that triangles stand on.
constexpr double kPointTurning = 0.1, kChordTurning = 0.12;
/// Of a radius: polylines stay further from other edges than they stand off their own, and
/// triangles between them are no slivers.
constexpr double kClearChord = 0.03;
/// rad: about as much, between nodes on a round face. Faces with straight lines are flattened to
/// what such an angle spans: so triangles stand along the lines and cut nothing short.
constexpr double kFaceTurning = 0.14;
/// Of a face's area: what chords may take from it; where more lacks, it was not covered.
constexpr double kAreaError = 0.05;
/// Kernel units: below, a chord says nothing of a direction.
constexpr double kShortestChord = 1e-3;

/// In how many even steps an arc is followed.
inline int steps_of(double angle, double turning) {
  return std::max(2, static_cast<int>(std::ceil(angle / turning)));
}

/// A place on a curve with the derivative there.
struct CurvePoint {
  Vec3 p, derivative;
};

/// Points of a curve from one parameter to another, by halving; `shortest`: kShortestChord in the
/// curve's unit.
template <typename At>
std::vector<Vec3> points_by_halving(const At& at, double first, double last, double shortest) {
  struct Sample {
    double t;
    Vec3 p, tangent;
  };
  const auto sample = [&](double t) {
    const CurvePoint c = at(t);
    const double speed = norm(c.derivative);
    return Sample{t, c.p, speed > 0 ? c.derivative / speed : Vec3{}};
  };
  const auto turns = [&](const Sample& a, const Sample& b) {
    const Vec3 chord = b.p - a.p;
    if (norm(chord) < shortest) return false;
    const Vec3 u = normalised(chord);
    return norm(u - a.tangent) > 0.5 * kPointTurning || norm(u - b.tangent) > 0.5 * kPointTurning;
  };
  Sample here = sample(first);
  std::vector<Vec3> points{here.p};
  std::vector<Sample> ahead{sample(last), sample(0.5 * (first + last))};
  while (!ahead.empty()) {
    const Sample next = ahead.back();
    if (turns(here, next)) {
      ahead.push_back(sample(0.5 * (here.t + next.t)));
      continue;
    }
    ahead.pop_back();
    points.push_back(next.p);
    here = next;
  }
  return points;
}

/// Gauss's rule of three points on each of so many parts of a curve: points, and vectors along it
/// that its integrals are sums over.
template <typename At>
std::vector<std::array<Vec3, 2>> integration_samples(const At& at, double first, double last,
                                                     std::size_t parts) {
  constexpr std::array<std::array<double, 2>, 3> kRule{
      {{-0.7745966692414834, 5.0 / 18}, {0, 8.0 / 18}, {0.7745966692414834, 5.0 / 18}}};
  const double step = (last - first) / static_cast<double>(parts);
  std::vector<std::array<Vec3, 2>> samples;
  for (std::size_t k = 0; k < parts; ++k)
    for (const auto& [x, weight] : kRule) {
      const CurvePoint c = at(first + step * (static_cast<double>(k) + 0.5 + 0.5 * x));
      samples.push_back({c.p, step * weight * c.derivative});
    }
  return samples;
}

}  // namespace remeshd::kernel
