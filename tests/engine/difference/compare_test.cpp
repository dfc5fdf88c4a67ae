#include "engine/difference/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/engine/difference/difference_case.h"

namespace remeshd {
namespace {

using test::DifferenceCase;
using ::testing::DoubleNear;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

ModelComparison compare_case(const DifferenceCase& c) {
  return compare(c.original, c.modified, &c.original_cells, &c.modified_cells, {});
}

DifferenceCase with_parameters(const std::string& model, std::vector<SetParameter> changes) {
  ModelEdit edit;
  for (SetParameter& change : changes) edit.edits.emplace_back(std::move(change));
  return DifferenceCase(test::case_model(model), edit);
}

TEST(CompareTest, ReportsFigure8InTheWordsOfTheProtocol) {
  const ModelComparison result = compare_case(DifferenceCase("fig8-ab"));
  EXPECT_EQ(result.method, "brep");
  ASSERT_EQ(result.features.size(), 2u);
  EXPECT_EQ(result.features[0].id, "block");
  EXPECT_THAT(result.features[0].cells, UnorderedElementsAre(Pair("++", DoubleNear(40000, 1e-6)),
                                                             Pair("+-", DoubleNear(8000, 1e-6))));
  EXPECT_THAT(result.features[1].cells, UnorderedElementsAre(Pair(".-", DoubleNear(8000, 1e-6))));
  EXPECT_THAT(result.features[0].faces, UnorderedElementsAre(Pair("bb", DoubleNear(7600, 1e-6)),
                                                             Pair("bn", DoubleNear(1200, 1e-6)),
                                                             Pair(".b", DoubleNear(1600, 1e-6))));
  EXPECT_THAT(result.features[0].vertices, UnorderedElementsAre(Pair("bb", 8), Pair(".b", 8)));
  EXPECT_NEAR(result.copycells, 40000, 1e-6);
  EXPECT_EQ(result.newcells, 0);
}

TEST(CompareTest, TheSevenCasesAreComparedByBrep) {
  for (const test::EditCase& edit : test::seven_cases()) {
    const ModelComparison result = compare_case(DifferenceCase(edit.edit));
    EXPECT_EQ(result.method, "brep") << edit.edit << ": " << result.remark;
    EXPECT_NEAR(result.copycells + result.newcells, edit.modified_volume, result.error_bound);
  }
}

TEST(CompareTest, ModelsAloneAreEnough) {
  const DifferenceCase c("fig9-ab");
  const ModelComparison given = compare_case(c);
  const ModelComparison built = compare(c.original, c.modified, nullptr, nullptr, {});
  EXPECT_EQ(given.features, built.features);
}

TEST(CompareTest, SmallMotionsAreComparedByMembershipWithinTheStatedBound) {
  for (const double delta : {1e-3, 1e-6}) {
    const DifferenceCase c = with_parameters("fig11-a", {{"hole_radius", 8 - delta}});
    const ModelComparison result = compare_case(c);
    EXPECT_EQ(result.method, "membership");
    EXPECT_THAT(result.remark, ::testing::HasSubstr("moved by less"));
    const double ring = 15 * 3.14159265358979 * delta * (16 - delta);
    EXPECT_NEAR(result.newcells, ring, result.error_bound);
    EXPECT_LT(result.error_bound, 0.2 * ring);
    EXPECT_NEAR(result.copycells + result.newcells, c.modified_cells.volume, 1e-9);
    EXPECT_NEAR(result.features[0].cells.at("-+"), ring, result.error_bound);
    EXPECT_NEAR(result.features[1].cells.at("-."), ring, result.error_bound);
    // The hole's wall is another face now, to the base and to the hole.
    EXPECT_NEAR(result.features[0].faces.at(".b"), 240 * 3.14159265358979, 1);
    EXPECT_NEAR(result.features[0].faces.at("b."), 240 * 3.14159265358979, 1);
  }
}

TEST(CompareTest, WhatASmallMotionTakesAwayIsNotCountedAsThereStill) {
  // The rib, 10 wide, loses half of a thousandth on each side.
  const DifferenceCase c = with_parameters("fig11-a", {{"rib_dx", 10 - 1e-3}});
  const ModelComparison result = compare_case(c);
  ASSERT_EQ(result.method, "membership");
  const FeatureComparison& rib = result.features[2];
  ASSERT_EQ(rib.id, "rib");
  const double lost = rib.cells.at("+.");
  EXPECT_GT(lost, 0);
  double before = 0;
  for (const Cell& cell : c.original_cells.complex({}).cells)
    if (cell.positive && std::ranges::binary_search(cell.owners, 2)) before += cell.volume;
  EXPECT_NEAR(rib.cells.at("++"), before - lost, 1e-9 * before);
}

TEST(CompareTest, AnOverlayThatDisagreesWithMembershipIsNotBelieved) {
  // A ball cut out of a corner of a block, and another ball in its stead, 1e-4 further: the CAD
  // kernel takes their surfaces for one in part and finds newcells of a negative volume.
  const auto with_ball = [](const std::string& id, double by) {
    const FeatureSource ball = test::feature(id, "sphere", {{"radius", 6.0}});
    return evaluate(
        test::model_of({test::block("block", 20, 20, 10),
                        test::placed(ball, 10, 10 + by, 10 + by, Nature::Subtractive)}));
  };
  const ModelComparison result =
      compare(with_ball("ball", 0), with_ball("other", 1e-4), nullptr, nullptr, {});
  EXPECT_EQ(result.method, "membership");
  EXPECT_EQ(result.remark, "the overlay's volumes disagree with membership");
  EXPECT_NEAR(result.newcells, 6 * 6 * 1e-4 * 3.14159265358979 / 2, result.error_bound);
}

TEST(CompareTest, NothingMovedIsNoDifference) {
  const DifferenceCase c(test::case_model("tool1-a"), ModelEdit{});
  const ModelComparison result = compare_case(c);
  EXPECT_EQ(result.newcells, 0);
  for (const FeatureComparison& feature : result.features)
    for (const auto& [name, volume] : feature.cells)
      EXPECT_TRUE(name == "++" || name == "--") << feature.id << " " << name << " " << volume;
}

TEST(SmallestMotionTest, IsTheSmallestOfPlacementsAndSizes) {
  const auto motion = [](const std::string& model, std::vector<SetParameter> changes) {
    const DifferenceCase c = with_parameters(model, std::move(changes));
    return smallest_motion(c.original, c.modified);
  };
  EXPECT_EQ(motion("fig11-a", {}), HUGE_VAL);
  EXPECT_NEAR(motion("fig11-a", {{"hole_x", -20.5}}), 0.5, 1e-12);
  EXPECT_NEAR(motion("fig11-a", {{"hole_radius", 8.25}}), 0.25, 1e-12);
  EXPECT_NEAR(motion("fig11-a", {{"rib_dx", 10.5}}), 0.25, 1e-12) << "each side moves by half";
  EXPECT_NEAR(motion("fig11-a", {{"hole_x", -10.0}, {"hole_radius", 8.001}}), 0.001, 1e-12);
}

TEST(SmallestMotionTest, IsThatOfFeaturesAgainstEachOtherToo) {
  const auto blocks = [](double first, double second) {
    return evaluate(test::model_of({test::placed(test::block("a", 1, 1, 1), first, 0, 0),
                                    test::placed(test::block("b", 1, 1, 1), second, 0, 0)}));
  };
  EXPECT_NEAR(smallest_motion(blocks(0, 3), blocks(0.5, 3.5)), 0.5, 1e-12) << "as one";
  EXPECT_NEAR(smallest_motion(blocks(0, 3), blocks(0.5, 3.501)), 0.001, 1e-12);
}

}  // namespace
}  // namespace remeshd
