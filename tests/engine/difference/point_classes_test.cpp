#include "engine/difference/point_classes.h"

#include <gtest/gtest.h>

#include "engine/base/random.h"
#include "engine/difference/line_volumes.h"
#include "engine/difference/point_areas.h"
#include "engine/kernel/brep.h"
#include "tests/engine/difference/difference_case.h"

namespace remeshd {
namespace {

using enum DifferenceClass;
using test::DifferenceCase;

int index_of(const PointClasses& classes, const std::string& id) {
  for (std::size_t i = 0; i < classes.features().size(); ++i)
    if (classes.features()[i].id == id) return static_cast<int>(i);
  return -1;
}

TEST(PointClassesTest, CellsOfFigure11AtPointsOfTheModifiedModel) {
  const DifferenceCase c("fig11-ab");
  const PointClasses classes(c.original, c.modified);
  const int base = index_of(classes, "base"), hole = index_of(classes, "hole"),
            rib = index_of(classes, "rib");
  EXPECT_EQ(classes.cell(base, {30, 10, 5}), IdenticalYes);
  EXPECT_EQ(classes.cell(base, {-26, 0, 5}), ToYes) << "where the hole was";
  EXPECT_EQ(classes.cell(base, {-6, 0, 5}), ToNo) << "where it is";
  EXPECT_EQ(classes.cell(base, {-14, 0, 5}), IdenticalNo) << "where both are";
  EXPECT_EQ(classes.cell(hole, {-6, 0, 5}), IdenticalNo) << "the hole moved along";
  EXPECT_EQ(classes.cell(hole, {-3, 0, 5}), OldNo) << "the hole shrank";
  EXPECT_EQ(classes.cell(rib, {15, 0, 20}), IdenticalYes);
  EXPECT_EQ(classes.cell(rib, {8, 0, 20}), NewYes);
  EXPECT_EQ(classes.cell(rib, {0, 0, 20}), Artefact) << "not in the rib";
  EXPECT_TRUE(classes.in_copycell({30, 10, 5}));
  EXPECT_TRUE(classes.in_newcell({-26, 0, 5})) << "persistent-different alone never copies";
  EXPECT_TRUE(classes.in_newcell({8, 0, 20}));
  EXPECT_FALSE(classes.in_copycell({-6, 0, 5}) || classes.in_newcell({-6, 0, 5}));
}

TEST(PointClassesTest, FeaturesThatAreNoMoreComeLastWhicheverTheyWere) {
  const FeatureModel three = evaluate(test::model_of(
      {test::block("a", 10, 10, 10), test::block("b", 9, 9, 30), test::block("c", 8, 40, 8)}));
  const auto without = [&](std::size_t f) {
    FeatureModel model = three;
    model.features.erase(model.features.begin() + static_cast<std::ptrdiff_t>(f));
    return model;
  };
  for (const std::size_t f : {0U, 1U, 2U}) {
    const PointClasses classes(three, without(f));
    ASSERT_EQ(classes.features().size(), 3U);
    EXPECT_EQ(classes.features().back().id, three.features[f].id);
    EXPECT_EQ(classes.features().back().original, static_cast<int>(f));
    EXPECT_EQ(classes.features().back().modified, -1);
  }
}

TEST(PointClassesTest, FacesOfTheBaseOfFigure7) {
  const DifferenceCase c("fig6-ab");
  const PointClasses classes(c.original, c.modified);
  const int base = index_of(classes, "base"), rib = index_of(classes, "rib");
  const Vec3 up{0, 0, 1};
  EXPECT_EQ(classes.face(base, {30, 0, 10}, up, 1e-9), IdenticalYes);
  EXPECT_EQ(classes.face(base, {-20, 3, 10}, up, 1e-9), ToYes) << "the old foot";
  EXPECT_EQ(classes.face(base, {10, 3, 10}, up, 1e-9), ToNo) << "the new foot";
  EXPECT_EQ(classes.face(rib, {10, 3, 10}, up, 1e-9), IdenticalNo);
  EXPECT_EQ(classes.face(base, {30, 0, 5}, up, 1e-9), Artefact) << "no face there";
}

/// The class of the overlay at a point: every cell of the overlay must hold one class only.
TEST(PointClassesTest, BothWaysAgreeOnEveryCellOfEveryOverlay) {
  for (const char* name : {"fig8-ab", "fig9-ab", "fig10-ab", "fig11-ab", "tool1-ac", "tool3-ab"}) {
    const DifferenceCase c(name);
    const PointClasses classes(c.original, c.modified);
    const VolumeEstimate lines = estimate_volumes(classes, {16384, 3}, {});
    for (std::size_t f = 0; f < classes.features().size(); ++f) {
      const FeatureDifference d = c.of(classes.features()[f].id);
      for (const DifferenceClass k : kAllClasses) {
        if (k == Artefact) continue;
        EXPECT_NEAR(d.cell_volumes[k], lines.features[f][k],
                    lines.feature_errors[f][k] + 1e-6 * c.modified_cells.volume)
            << name << " " << d.id << " " << cell_class_name(k);
      }
    }
  }
}

TEST(PointClassesTest, BothWaysAgreeOnCopiedVolumeOfTheSevenCases) {
  for (const test::EditCase& edit : test::seven_cases()) {
    const DifferenceCase c(edit.edit);
    const CombinedModel brep = combined_modified_model(c.before(), c.after(), {});
    const PointClasses classes(c.original, c.modified);
    const VolumeEstimate lines = estimate_volumes(classes, {32768, 1}, {});
    EXPECT_NEAR(brep.copycell_volume, lines.copycells, lines.copycells_error + 1e-6) << edit.edit;
    EXPECT_NEAR(brep.newcell_volume, lines.newcells, lines.newcells_error + 1e-6) << edit.edit;
    EXPECT_LT(lines.copycells_error, 0.005 * edit.modified_volume) << "or agreeing says little";
  }
}

TEST(PointClassesTest, BothWaysAgreeOnAreas) {
  for (const char* name : {"fig6-ab", "fig11-ab"}) {
    const DifferenceCase c(name);
    const PointClasses classes(c.original, c.modified);
    const auto areas = estimate_areas(classes, c.before(), c.after(), 20000, {});
    for (std::size_t f = 0; f < classes.features().size(); ++f) {
      const FeatureDifference d = c.of(classes.features()[f].id);
      for (const DifferenceClass k : kAllClasses) {
        if (k == Artefact) continue;
        EXPECT_NEAR(d.face_areas[k], areas[f][k], 0.003 * c.modified_cells.area)
            << name << " " << d.id << " " << geometry_class_name(k);
      }
    }
  }
}

TEST(PointClassesTest, ALayerCountsHoweverThinItIs) {
  for (const double delta : {1e-2, 1e-5, 1e-8}) {
    ModelEdit edit;
    edit.edits = {SetParameter{"pin_radius", 4 + delta}};
    const ModelSource source = test::case_model("tool1-a");
    const FeatureModel original = evaluate(source), modified = evaluate(apply(source, edit));
    const VolumeEstimate lines = estimate_volumes(PointClasses(original, modified), {32768, 1}, {});
    const double layer = 4 * 15 * 3.14159265358979 * delta * (8 + delta);
    EXPECT_LT(lines.newcells_error, 0.2 * layer) << delta;
    EXPECT_NEAR(lines.newcells, layer, lines.newcells_error) << delta;
  }
}

TEST(PointClassesTest, TheSameSeedGivesTheSameBits) {
  const DifferenceCase c("fig11-ab");
  const PointClasses classes(c.original, c.modified);
  const VolumeEstimate a = estimate_volumes(classes, {1024, 5}, {});
  const VolumeEstimate b = estimate_volumes(classes, {1024, 5}, {});
  EXPECT_EQ(a.features, b.features);
  EXPECT_EQ(a.copycells, b.copycells);
}

}  // namespace
}  // namespace remeshd
