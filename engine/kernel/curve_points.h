#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/base/vec.h"

namespace remeshd::kernel {

/// Turning, rad: between points of a BrepEdge, for which 6 degrees are promised, and between the
/// chords of a circle's polyline in the triangulation.
constexpr double kPointTurning = 0.1, kChordTurning = 0.12;
/// x a radius: gap below which a round edge or face nearly touches another, and local_fuse gives
/// up. So polylines stay nearer to their own curves than to others, and triangles between them are
/// no slivers.
constexpr double kClearChord = 0.03;
/// Turning, rad: between nodes on a doubly curved face. Cylinders and cones are shrunk along their
/// straight lines to the length that this angle spans, so that triangles follow the lines and none
/// cuts off a piece across them.
constexpr double kFaceTurning = 0.14;
/// x the area of a face: the area of its triangles may differ by so much because of chords; where
/// it differs by more, they do not cover the face.
constexpr double kAreaError = 0.05;
/// Kernel units: the direction of a shorter chord tells nothing.
constexpr double kShortestChord = 1e-3;

/// The number of equal steps, two or more, that each turn by `turning` at most.
inline int steps_of(double angle, double turning) {
  return std::max(2, static_cast<int>(std::ceil(angle / turning)));
}

/// A place on a curve with the derivative there.
struct CurvePoint {
  Vec3 p, derivative;
};

/// Points of a curve between two parameters, which are halved until neighbours turn by about
/// kPointTurning at most; `shortest`: kShortestChord in the curve's unit.
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

/// Three-point Gauss rule on each of `parts` equal parts of a curve: points, each with the
/// derivative times its weight, so that an integral along the curve is a sum.
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
