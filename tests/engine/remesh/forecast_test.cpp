#include "engine/remesh/forecast.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

Forecast forecast_of(const FeatureModel& model, const MeshOptions& options) {
  const CellularModel cells = build_cells(model, kRun);
  const Density density = resolve_density(Revision::none(), options, model, cells, kRun);
  return forecast(density, model, cells, options, 0, kRun);
}

MeshOptions sized_by(std::optional<std::uint32_t> nodes, std::optional<double> size = {}) {
  MeshOptions options{.nodes = nodes, .size = size};
  options.sizing.even = false;
  return options;
}

TEST(Forecast, OfAnEvenMeshHasTheNodesThatAreAskedFor) {
  const FeatureModel model = test::case_features("tool1-a");
  EXPECT_EQ(forecast_of(model, {.nodes = 3000}).nodes, 3000U);
  EXPECT_TRUE(forecast_of(model, {.nodes = 3000}).details.empty());
}

TEST(Forecast, HasTheNodesOfTheMeshWithinThreeInAHundred) {
  const ModelSource source = test::case_model("tool1-a");
  for (const MeshOptions& options : {sized_by(4000), sized_by({}, 4.0)}) {
    const Revision made = make_revision(Revision::none(), source, options, kRun);
    const double nodes = made.report.counts.nodes;
    EXPECT_NEAR(forecast_of(made.model, options).nodes, nodes, 0.03 * nodes);
  }
}

TEST(Forecast, HasMoreMemoryWhereThereAreMidNodes) {
  const FeatureModel model = test::case_features("tool1-a");
  MeshOptions options{.nodes = 3000};
  const std::uint64_t straight = forecast_of(model, options).bytes;
  options.order = 2;
  EXPECT_GT(forecast_of(model, options).bytes, straight + 3000 * 6 * sizeof(Vec3));
}

TEST(Forecast, NamesWhatAsksForTheShortestEdgesFirst) {
  const Forecast f = forecast_of(test::case_features("tool1-a"), sized_by(4000));
  ASSERT_FALSE(f.details.empty());
  for (std::size_t k = 1; k < f.details.size(); ++k)
    EXPECT_LE(f.details[k - 1].size, f.details[k].size);
  EXPECT_FALSE(f.details.front().feature.empty());
  EXPECT_FALSE(f.details.front().face.empty());
}

TEST(Forecast, NamesFacesThatTheModelAsksForEdgesOn) {
  FeatureModel model = test::case_features("simple-a");
  model.sizes = {{"fine", std::vector<SizedFaces>{{{0, {"top"}, false, {}}, 0.5}}}};
  const Forecast f = forecast_of(model, sized_by({}, 8.0));
  ASSERT_FALSE(f.details.empty());
  EXPECT_EQ(f.details.front().feature, model.features.front().id);
  EXPECT_EQ(f.details.front().face, "top");
  EXPECT_EQ(f.details.front().size, 0.5);
}

TEST(Forecast, OfMoreNodesTakesMoreMemoryAndTime) {
  const FeatureModel model = test::case_features("simple-a");
  const Forecast few = forecast_of(model, {.nodes = 2000});
  const Forecast many = forecast_of(model, {.nodes = 200000});
  EXPECT_GT(many.bytes, 10 * few.bytes);
  EXPECT_GT(many.seconds, 10 * few.seconds);
}

}  // namespace
}  // namespace remeshd
