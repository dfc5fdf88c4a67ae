#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"

namespace remeshd {

inline FeatureSource block(std::string id, std::array<Scalar, 3> origin,
                           std::array<double, 3> size) {
  FeatureSource source =
      test::feature(std::move(id), "block", {{"dx", size[0]}, {"dy", size[1]}, {"dz", size[2]}});
  source.placement.origin = std::move(origin);
  return source;
}

inline FeatureSource cylinder(std::string id, std::array<Scalar, 3> origin, double radius,
                              double height) {
  FeatureSource source =
      test::feature(std::move(id), "cylinder", {{"radius", radius}, {"height", height}});
  source.placement.origin = std::move(origin);
  return source;
}

inline FeatureSource minus(FeatureSource source) {
  source.nature = Nature::Subtractive;
  return source;
}

inline CellularModel cells_of(std::vector<FeatureSource> features) {
  return build_cells(evaluate(test::model_of(std::move(features))), Run());
}

}  // namespace remeshd
