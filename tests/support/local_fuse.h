#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/kernel/brep.h"
#include "engine/local_fuse/arrangement/intersection_curves.h"
#include "engine/local_fuse/arrangement/planar_arrangement.h"
#include "engine/local_fuse/gave_up.h"
#include "tests/support/cases.h"

namespace remeshd::test {

/// Why something was given up, `slabs: two heights are ...`; empty where it was not.
template <typename T>
std::string reason_of(const Tried<T>& tried) {
  return tried ? "" : text_of(tried.why());
}

/// A model with what the functions of local_fuse ask for, all its features taken.
struct FuseInput {
  FeatureModel model;
  Membership membership;
  std::vector<int> features;
  double diagonal = 0;
  Clearance clearance;

  explicit FuseInput(const ModelSource& source)
      : model(evaluate(source)), membership(model), features(all_of(model)) {
    Box box;
    for (const Solid& solid : membership.solids()) box.add(solid.bounds());
    diagonal = box.diagonal();
    clearance = {kSameOutline * diagonal, kClearOutline * diagonal};
  }
};

/// The largest angle between two points of a circle or arc that follow each other, in degrees;
/// points that are not on it count as a whole turn.
inline double largest_turning(const kernel::BrepEdge& circle) {
  double largest = 0;
  for (std::size_t i = 0; i + 1 < circle.points.size(); ++i) {
    const Vec3 a = circle.points[i] - circle.centre, b = circle.points[i + 1] - circle.centre;
    const bool on = std::fabs(norm(a) - circle.radius) < 1e-9 && dot(cross(a, b), circle.axis) > 0;
    largest = std::max(largest, on ? std::acos(dot(a, b) / dot(a, a)) : 2 * std::numbers::pi);
  }
  return largest * 180 / std::numbers::pi;
}

}  // namespace remeshd::test
