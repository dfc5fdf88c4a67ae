// The paper's small examples (Figs. 6 to 11), with the numbers of tests/cases/README.md.
#include "engine/difference/feature_difference.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/engine/difference/difference_case.h"

namespace remeshd {
namespace {

using test::cells;
using test::DifferenceCase;
using test::edges;
using test::faces;
using test::vertices;

bool all_persistent_identical(const FeatureDifference& d) {
  for (const auto* elements : {&d.cells, &d.faces, &d.edges, &d.vertices})
    for (const DifferenceElement& element : *elements)
      if (element.value != DifferenceClass::IdenticalYes &&
          element.value != DifferenceClass::IdenticalNo)
        return false;
  return !d.cells.empty();
}

TEST(FeatureDifferenceTest, Figure6AMovedRibIsPersistentIdenticalInEveryElement) {
  const DifferenceCase c("fig6-ab");
  for (const char* id : {"rib", "knob1", "knob2"})
    EXPECT_TRUE(all_persistent_identical(c.of(id))) << id;
}

TEST(FeatureDifferenceTest, Figure7TheBaseKnowsWhereTheRibStoodAndStands) {
  const FeatureDifference base = DifferenceCase("fig6-ab").of("base");
  EXPECT_EQ(cells(base), "++ 32000");
  EXPECT_EQ(faces(base), "bb 8200 bn 300 nb 300") << "the new foot and the old one";
  EXPECT_EQ(edges(base), "bb 520 .b 80 b. 80") << "round the new foot and the old one";
  EXPECT_EQ(vertices(base), "bb 8 .b 4 b. 4");
  int old_edges = 0, new_edges = 0;
  for (const DifferenceElement& edge : base.edges) {
    old_edges += edge.value == DifferenceClass::OldYes;
    new_edges += edge.value == DifferenceClass::NewYes;
  }
  EXPECT_EQ(old_edges, 4);
  EXPECT_EQ(new_edges, 4);
}

TEST(FeatureDifferenceTest, Figure8ASlotChangesTheNatureOfAPartOfItsBlock) {
  const DifferenceCase c("fig8-ab");
  EXPECT_EQ(cells(c.of("block")), "++ 40000 +- 8000");
  EXPECT_EQ(cells(c.of("slot")), ".- 8000");
  // The slot's two walls and floor are new to the block; its top and two ends were boundary.
  EXPECT_EQ(faces(c.of("block")), "bb 7600 bn 1200 .b 1600");
}

TEST(FeatureDifferenceTest, Figure9AnAddedFeatureIsNewAndItsFootIsPersistentDifferent) {
  const DifferenceCase c("fig9-ab");
  EXPECT_TRUE(all_persistent_identical(c.of("F2")));
  const FeatureDifference f3 = c.of("F3");
  EXPECT_EQ(cells(f3), ".+ 3840");
  for (const auto* elements : {&f3.cells, &f3.faces, &f3.edges, &f3.vertices})
    for (const DifferenceElement& element : *elements)
      EXPECT_EQ(find_classification(element.value)->relation, Relation::New);
  const FeatureDifference f1 = c.of("F1");
  EXPECT_EQ(cells(f1), "++ 32000");
  EXPECT_EQ(faces(f1), "bb 8160 bn 320 nn 320");
  EXPECT_EQ(edges(f1), "bb 592 .b 72") << "the four edges of the foot of F3";
  EXPECT_EQ(vertices(f1), "bb 12 .b 4");
}

TEST(FeatureDifferenceTest, Figure10AGrownFeatureAlignedOnItsCentreHasNoOldCell) {
  const DifferenceCase c("fig10-ab");
  const FeatureDifference f2 = c.of("F2");
  EXPECT_EQ(cells(f2), "++ 3840 .+ 4800");
  EXPECT_GT(f2.face_areas[DifferenceClass::OldYes], 0);
  EXPECT_GT(f2.edge_lengths[DifferenceClass::OldYes], 0);
  // The centre rises from 6 to 9 above the origin: what stays put moves up by 3.
  const Transform down = to_original(c.original.features[1], c.modified.features[1]);
  EXPECT_EQ(down, Transform::translation({0, 0, -3}));
}

TEST(FeatureDifferenceTest, Figure11EachFeatureHasItsOwnPointOfView) {
  const DifferenceCase c("fig11-ab");
  EXPECT_EQ(cells(c.of("base")), "++ 55686.11 +- 1297.96 -+ 2617.43 -- 398.5");
  EXPECT_EQ(cells(c.of("hole")), "-- 1696.46 -. 1319.47");
  EXPECT_EQ(cells(c.of("rib")), "++ 10000 .+ 6000");
}

TEST(FeatureDifferenceTest, WhereOriginalCrossesModifiedGeometryElementsAreInNeitherModel) {
  const FeatureDifference base = DifferenceCase("fig11-ab").of("base");
  // The two round walls cross in two upright lines within the base.
  EXPECT_NEAR(base.edge_lengths[DifferenceClass::Artefact], 2 * 15, 1e-6);
  EXPECT_EQ(base.vertex_counts[DifferenceClass::Artefact], 4);
  EXPECT_EQ(base.face_areas[DifferenceClass::Artefact], 0);
  EXPECT_EQ(base.cell_volumes[DifferenceClass::Artefact], 0);
}

TEST(FeatureDifferenceTest, EachModelCanBeRecoveredFromTheDifference) {
  // Sect. 4.3: without new elements it is the original's feature, without old ones the modified's.
  for (const char* name : {"fig10-ab", "fig11-ab", "tool3-ab"}) {
    const DifferenceCase c(name);
    for (const FeatureDifference& d : difference_model(c.before(), c.after(), {})) {
      double original = 0, modified = 0, original_area = 0, modified_area = 0;
      for (const Classification& row : kClassifications) {
        if (row.original != Mark::Absent) original += d.cell_volumes[row.value];
        if (row.modified != Mark::Absent) modified += d.cell_volumes[row.value];
        if (row.original != Mark::Absent) original_area += d.face_areas[row.value];
        if (row.modified != Mark::Absent) modified_area += d.face_areas[row.value];
      }
      const auto owned = [&](const FeatureModel& model, const auto& elements, auto measure) {
        double sum = 0;
        for (const auto& e : elements)
          if (std::ranges::count(e.owners, model.index_of(d.id))) sum += measure(e);
        return sum;
      };
      const auto volume = [](const Cell& x) { return x.volume; };
      const auto area = [](const CellFace& x) { return x.area; };
      EXPECT_NEAR(original, owned(c.original, c.original_cells.complex().cells, volume), 1e-6)
          << d.id;
      EXPECT_NEAR(modified, owned(c.modified, c.modified_cells.complex().cells, volume), 1e-6)
          << d.id;
      EXPECT_NEAR(original_area, owned(c.original, c.original_cells.complex().faces, area), 1e-6)
          << d.id;
      EXPECT_NEAR(modified_area, owned(c.modified, c.modified_cells.complex().faces, area), 1e-6)
          << d.id;
    }
  }
}

TEST(FeatureDifferenceTest, ARemovedFeatureIsOldInEveryElement) {
  ModelEdit edit;
  edit.edits = {RemoveFeature{"slot2"}};
  const DifferenceCase c(test::case_model("fig5"), edit);
  const auto model = difference_model(c.before(), c.after(), {});
  ASSERT_EQ(model.size(), 3u);
  EXPECT_EQ(model.back().id, "slot2");
  EXPECT_EQ(cells(model.back()), "-. 5760");
}

TEST(FeatureDifferenceTest, ATurnedFeatureIsAlignedToo) {
  ModelSource source = test::case_model("fig9-a");
  PlacementSource turned = source.features[1].placement;
  turned.x_axis = {1.0, 1.0, 0.0};
  ModelEdit edit;
  edit.edits = {SetPlacement{"F2", turned}};
  const DifferenceCase c(source, edit);
  EXPECT_TRUE(all_persistent_identical(c.of("F2")));
  EXPECT_EQ(cells(c.of("F1")), "++ 32000");
  EXPECT_NEAR(c.of("F1").face_areas[DifferenceClass::ToNo],
              c.of("F1").face_areas[DifferenceClass::ToYes], 1e-9);
}

TEST(FeatureDifferenceTest, AnEditThatChangesNothingLeavesEverythingPersistentIdentical) {
  for (const char* name : {"tool1-a", "tool2-d"}) {
    const DifferenceCase c(test::case_model(name), ModelEdit{});
    for (const FeatureDifference& d : difference_model(c.before(), c.after(), {}))
      EXPECT_TRUE(all_persistent_identical(d)) << name << " " << d.id;
  }
}

}  // namespace
}  // namespace remeshd
