#pragma once

#include <vector>

#include "tests/bench/plot.h"
#include "tests/bench/session.h"

namespace remeshd::bench {

/// A plate with a grid of through holes and pins in turn, so many features in all (at least 2) on a
/// plate of always the same size; the edit moves one in the middle.
Subject hole_plate(int features);

/// `plate-64`.
std::string hole_plate_name(int features);

/// What the growth of time is measured at.
struct GrowthPoints {
  std::vector<std::uint32_t> nodes{15'000, 30'000, 100'000, 300'000, 1'000'000};
  std::vector<int> features{16, 32, 64, 128, 256};
  std::uint32_t nodes_of_features = 30'000;
};

/// Time against nodes: simple-ab, whose change stays the same in the model's unit.
Plot plot_nodes(const Results& results, const GrowthPoints& points);

/// Time against the number of features.
Plot plot_features(const Results& results, const GrowthPoints& points);

}  // namespace remeshd::bench
