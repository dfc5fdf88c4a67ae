#include "engine/difference/combined_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/difference/difference_case.h"

namespace remeshd {
namespace {

using test::DifferenceCase;
using ::testing::DoubleNear;
using ::testing::UnorderedElementsAre;

std::vector<double> newcells(const CombinedModel& model) {
  std::vector<double> volumes;
  for (const CombinedCell& cell : model.cells)
    if (cell.newcell) volumes.push_back(cell.volume);
  return volumes;
}

TEST(CombinedModelTest, Figure12NewcellsAreWhereTheHoleWasAndWhereTheRibGrew) {
  const DifferenceCase c("fig11-ab");
  const CombinedModel combined = combined_modified_model(c.before(), c.after(), {});
  EXPECT_THAT(newcells(combined),
              UnorderedElementsAre(DoubleNear(2233.0022, 1e-3), DoubleNear(384.4262, 1e-3),
                                   DoubleNear(3000, 1e-6), DoubleNear(3000, 1e-6)))
      << "the old circle, carried along by the hole, splits the first";
}

TEST(CombinedModelTest, Figure12EveryCellOfTheModifiedModelCanBeSelected) {
  const DifferenceCase c("fig11-ab");
  const CombinedModel combined = combined_modified_model(c.before(), c.after(), {});
  double positive = 0;
  for (const CombinedCell& cell : combined.cells) {
    if (cell.positive) positive += cell.volume;
    EXPECT_EQ(cell.positive, cell.copycell || cell.newcell);
    EXPECT_FALSE(cell.copycell && cell.newcell);
    EXPECT_FALSE(cell.views.empty());
  }
  EXPECT_NEAR(positive, c.modified_cells.volume, 1e-6);
}

TEST(CombinedModelTest, FeaturesThatOverlapClassifyTheSameCellDifferently) {
  // Where the smaller hole now is and base was: negative to the base's view by change, to the
  // hole's all along.
  const DifferenceCase c("fig11-ab");
  const CombinedModel combined = combined_modified_model(c.before(), c.after(), {});
  const std::vector<PointOfView> expected{{"base", DifferenceClass::ToNo},
                                          {"hole", DifferenceClass::IdenticalNo}};
  double volume = 0;
  for (const CombinedCell& cell : combined.cells)
    if (cell.views == expected) volume += cell.volume;
  EXPECT_NEAR(volume, 1297.96, 5e-3);
}

TEST(CombinedModelTest, TheCombinedOriginalModelPlacesTheFeaturesAsTheyWere) {
  const DifferenceCase c("fig11-ab");
  const CombinedModel combined = combined_original_model(c.before(), c.after(), {});
  double original = 0;
  for (const CombinedCell& cell : combined.cells) {
    if (cell.positive) original += cell.volume;
    EXPECT_FALSE(cell.copycell || cell.newcell);
  }
  EXPECT_NEAR(original, c.original_cells.volume, 1e-6);
}

TEST(CombinedModelTest, WhatIsCopiedAndWhatIsNewMakeUpTheModifiedModel) {
  for (const test::EditCase& edit : test::seven_cases()) {
    const DifferenceCase c(edit.edit);
    const CombinedModel combined = combined_modified_model(c.before(), c.after(), {});
    EXPECT_NEAR(combined.copycell_volume + combined.newcell_volume, edit.modified_volume, 1e-5)
        << edit.edit;
  }
}

TEST(CombinedModelTest, AMovedRibLeavesNoNewcell) {
  const DifferenceCase c("fig6-ab");
  EXPECT_EQ(combined_modified_model(c.before(), c.after(), {}).newcell_volume, 0);
}

TEST(CombinedModelTest, TheFacesOfAnOldFootChangeToBoundary) {
  const DifferenceCase c("fig6-ab");
  double foot = 0;
  for (const CombinedFace& face : combined_modified_model(c.before(), c.after(), {}).faces)
    if (face.views == std::vector<PointOfView>{{"base", DifferenceClass::ToYes}}) foot += face.area;
  EXPECT_NEAR(foot, 300, 1e-9);
}

}  // namespace
}  // namespace remeshd
