#include "tests/bench/growth.h"

#include <gmock/gmock.h>

#include <numbers>

#include "engine/cellular/cellular_model.h"

namespace remeshd::bench {
namespace {

TEST(HolePlate, HasSoManyFeaturesAndMovesOneOfThem) {
  for (const int features : {2, 16, 33, 256}) {
    const Subject plate = hole_plate(features);
    ASSERT_EQ(plate.original.features.size(), static_cast<std::size_t>(features));
    ASSERT_EQ(plate.modified.features.size(), static_cast<std::size_t>(features));
    int moved = 0;
    for (int k = 0; k < features; ++k)
      moved += plate.original.features[k] != plate.modified.features[k];
    EXPECT_EQ(moved, 1) << features;
  }
}

TEST(HolePlate, HolesAndPinsKeepClearOfEachOther) {
  const CellularModel cells = build_cells(evaluate(hole_plate(16).modified), remeshd::Run{});
  // Seven holes and eight pins on the first 15 sites of a grid of 4 by 4.
  const double disc = std::numbers::pi * 2.5 * 2.5;
  EXPECT_NEAR(cells.volume, 160.0 * 160 * 8 + (8 * 6 - 7 * 8) * disc, 1e-3);
}

TEST(PlotNodes, ShowsWhatWasMeasured) {
  const Results results{
      .groups = {{.name = "simple-ab", .nodes = 15000, .series = {{"regular 10", {{.cpu = .4}}}}},
                 {.name = "simple-ab", .nodes = 30000, .series = {{"regular 10", {{.cpu = .8}}}}}}};
  const Plot plot = plot_nodes(results, {.nodes = {15000, 30000, 100000}});
  ASSERT_EQ(plot.curves.size(), 3U);
  EXPECT_EQ(plot.curves[0].points.size(), 2U);
  EXPECT_EQ(plot.curves[0].name, "regular, x^1.00");
  EXPECT_TRUE(plot.curves[1].points.empty());
  EXPECT_TRUE(plot.curves[2].guide);
}

}  // namespace
}  // namespace remeshd::bench
