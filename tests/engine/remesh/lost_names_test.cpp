#include "engine/remesh/lost_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/cases.h"

namespace remeshd {
namespace {

using test::block;
using test::cylinder;
using test::feature;
using test::model_of;
using test::placed;
using testing::ElementsAre;
using testing::IsEmpty;
using Names = std::vector<std::vector<std::string>>;

constexpr Nature kHole = Nature::Subtractive;
const remeshd::Run kRun;  // GoogleTest's fixtures have a Run of their own

/// A revision of which only the model and the names on its mesh are known.
Revision named(const ModelSource& model, Names facets, Names cells = {{"plate"}}) {
  Revision r;
  r.model = evaluate(model);
  r.delivery.groups.facet_groups = std::move(facets);
  r.delivery.groups.cell_owners = std::move(cells);
  return r;
}

/// `CODE features | groups`, a line for each warning.
std::vector<std::string> told(const std::vector<Warning>& warnings) {
  std::vector<std::string> lines;
  for (const Warning& w : warnings) {
    std::string line(name_of(w.code));
    for (const std::string& id : w.features) line += " " + id;
    line += " |";
    for (const std::string& group : w.groups) line += " " + group;
    lines.push_back(line);
  }
  return lines;
}

ModelSource plate(double hole_x) {
  return model_of(
      {block("plate", 20, 20, 4), placed(cylinder("hole", 2, 6), hole_x, 10, -1, kHole)});
}

const Names kPlate{{"plate.bottom"}, {"plate.top"}};
const Names kPlateWithHole{{"hole.wall"}, {"plate.bottom"}, {"plate.top"}};

TEST(LostNames, AreNoneWhereTheNamesStay) {
  const Revision original = named(plate(10), kPlateWithHole);
  EXPECT_THAT(lost_names(nullptr, original), IsEmpty());
  EXPECT_THAT(lost_names(&original, named(plate(11), kPlateWithHole)), IsEmpty());
}

TEST(LostNames, AHoleMovedOffThePartIsTold) {
  const Revision original = named(plate(10), kPlateWithHole);
  const Revision without = named(plate(40), kPlate);
  EXPECT_THAT(told(lost_names(&original, without)),
              ElementsAre("FEATURE_WITHOUT_EFFECT hole | hole.wall"));
  EXPECT_THAT(told(lost_names(nullptr, without)), ElementsAre("FEATURE_WITHOUT_EFFECT hole |"));
  // It was told when it happened.
  EXPECT_THAT(lost_names(&without, named(plate(50), kPlate)), IsEmpty());
}

TEST(LostNames, AFaceOfAFeatureThatHasOthersIsToldByItself) {
  const Names with{{"rib.left"}, {"rib.right"}, {"rib.top"}};
  const ModelSource model = model_of({block("rib", 1, 1, 1)});
  const Revision original = named(model, with, {{"rib"}});
  EXPECT_THAT(told(lost_names(&original, named(model, {{"rib.top"}}, {{"rib"}}))),
              ElementsAre("FACE_LOST rib | rib.left", "FACE_LOST rib | rib.right"));
}

TEST(LostNames, FacesOfARemovedFeatureAreToldAtOnce) {
  const Revision original = named(plate(10), {{"hole.bottom"}, {"hole.wall"}, {"plate.top"}});
  const ModelSource model = model_of({block("plate", 20, 20, 4)});
  EXPECT_THAT(told(lost_names(&original, named(model, {{"plate.top"}}))),
              ElementsAre("FACE_LOST hole | hole.bottom hole.wall"));
}

TEST(LostNames, AGroupIsToldWhereItsFacesAreStillThere) {
  const ModelSource model = model_of({block("plate", 20, 20, 4), block("hub", 4, 4, 4)});
  const Names apart{{"hub.top"}, {"plate.top"}};
  const Revision original = named(model, {{"hub.top"}, {"hub.top", "plate.top"}, {"plate.top"}});
  EXPECT_THAT(told(lost_names(&original, named(model, apart))),
              ElementsAre("GROUP_EMPTIED | hub.top+plate.top"));
}

TEST(LostNames, WithoutEffectIsSaidOnlyWhereItIsCertain) {
  const auto with = [](const FeatureSource& other, const FeatureSource& last) {
    return model_of({block("plate", 20, 20, 4), other, last});
  };
  const auto unnamed_last = [&](const ModelSource& model) {
    return told(lost_names(
        nullptr, named(model, {{"plate.top"}, {"other.wall"}}, {{"plate"}, {"other", "plate"}})));
  };
  const FeatureSource far = placed(cylinder("hole", 2, 6), 40, 10, 0, kHole);
  // Away from everything.
  EXPECT_THAT(unnamed_last(with(placed(block("other", 2, 2, 2), 5, 5, 3), far)),
              ElementsAre("FEATURE_WITHOUT_EFFECT hole |"));
  // It may have swallowed the whole other one.
  EXPECT_THAT(unnamed_last(with(placed(block("other", 1, 1, 1), 40, 10, 1), far)), IsEmpty());
  // In a larger hole: boxes do not tell.
  EXPECT_THAT(unnamed_last(with(placed(cylinder("other", 4, 6), 40, 10, 0, kHole), far)),
              IsEmpty());
  // Where an additive one decided there would be material of it.
  EXPECT_THAT(unnamed_last(with(placed(block("other", 2, 2, 2), 5, 5, 3), block("rib", 1, 1, 1))),
              ElementsAre("FEATURE_WITHOUT_EFFECT rib |"));
}

TEST(LostNames, AFeatureThatHasMaterialHasAnEffect) {
  const ModelSource model = model_of({block("plate", 20, 20, 4), block("inlay", 1, 1, 1)});
  EXPECT_THAT(lost_names(nullptr, named(model, kPlate, {{"plate"}, {"plate", "inlay"}})),
              IsEmpty());
}

TEST(LostNames, AnEditThatMovesAHoleOffAPlateSaysSoInItsReport) {
  const Revision original = make_revision(nullptr, plate(10), {.nodes = 300}, kRun);
  EXPECT_THAT(told(lost_names(nullptr, original)), IsEmpty());
  const ModelSource moved = plate(40);
  const Revision remesh = make_revision(&original, moved, {}, kRun);
  EXPECT_THAT(told(remesh.report.warnings),
              testing::Contains("FEATURE_WITHOUT_EFFECT hole | hole.wall"));
  const Revision fresh = make_revision(nullptr, moved, {.nodes = 300}, kRun);
  EXPECT_THAT(told(fresh.report.warnings), testing::Contains("FEATURE_WITHOUT_EFFECT hole |"));
}

}  // namespace
}  // namespace remeshd
