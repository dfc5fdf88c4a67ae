#include "engine/delivery/lost_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <span>
#include <stop_token>
#include <tuple>

#include "engine/base/error.h"
#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::block;
using test::cylinder;
using test::feature;
using test::model_of;
using test::placed;
using testing::ElementsAre;
using testing::IsEmpty;
using NameLists = std::vector<std::vector<std::string>>;

constexpr Nature kHole = Nature::Subtractive;
using test::kRun;

/// A revision of which only the model and the names on its mesh are known.
Revision named(const ModelSource& model, NameLists facets, NameLists cells = {{"plate"}}) {
  Revision r;
  r.model = evaluate(model);
  r.output.groups.facet_groups = std::move(facets);
  r.output.groups.cell_owners = std::move(cells);
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

const NameLists kPlate{{"plate.bottom"}, {"plate.top"}};
const NameLists kPlateWithHole{{"hole.wall"}, {"plate.bottom"}, {"plate.top"}};

TEST(LostNames, AreNoneWhereTheNamesStay) {
  const Revision original = named(plate(10), kPlateWithHole);
  EXPECT_THAT(lost_names(Revision::none(), original, kRun), IsEmpty());
  EXPECT_THAT(lost_names(original, named(plate(11), kPlateWithHole), kRun), IsEmpty());
}

TEST(LostNames, AHoleMovedOffThePartIsTold) {
  const Revision original = named(plate(10), kPlateWithHole);
  const Revision without = named(plate(40), kPlate);
  EXPECT_THAT(told(lost_names(original, without, kRun)),
              ElementsAre("FEATURE_WITHOUT_EFFECT hole |", "FACE_LOST hole | hole.wall"));
  EXPECT_THAT(told(lost_names(Revision::none(), without, kRun)),
              ElementsAre("FEATURE_WITHOUT_EFFECT hole |"));
  // It was told when it happened.
  EXPECT_THAT(lost_names(without, named(plate(50), kPlate), kRun), IsEmpty());
}

TEST(LostNames, AFaceOfAFeatureThatHasOthersIsToldByItself) {
  const NameLists with{{"rib.left"}, {"rib.right"}, {"rib.top"}};
  const ModelSource model = model_of({block("rib", 1, 1, 1)});
  const Revision original = named(model, with, {{"rib"}});
  EXPECT_THAT(told(lost_names(original, named(model, {{"rib.top"}}, {{"rib"}}), kRun)),
              ElementsAre("FACE_LOST rib | rib.left", "FACE_LOST rib | rib.right"));
}

TEST(LostNames, AreToldWhereverTheTetsOfAFeatureLie) {
  // Whether a buried feature has material depends on the mesh; that its face is gone does not.
  const ModelSource model = model_of({block("plate", 20, 20, 4), block("inlay", 1, 1, 1)});
  const Revision original = named(model, {{"inlay.top"}, {"plate.top"}}, {{"plate"}, {"inlay"}});
  for (const NameLists& cells : {NameLists{{"plate"}}, NameLists{{"plate"}, {"inlay"}}})
    EXPECT_THAT(told(lost_names(original, named(model, {{"plate.top"}}, cells), kRun)),
                testing::Contains("FACE_LOST inlay | inlay.top"));
}

TEST(LostNames, AGroupInTheOtherOrderOfHistoryIsToldByItsNewName) {
  const NameLists then{{"hub.top", "plate.top"}, {"hub.top"}, {"plate.top"}};
  const NameLists now{{"plate.top", "hub.top"}, {"hub.top"}, {"plate.top"}};
  const FeatureSource below = block("plate", 20, 20, 4), hub = block("hub", 4, 4, 4);
  const auto warnings =
      lost_names(named(model_of({below, hub}), then), named(model_of({hub, below}), now), kRun);
  EXPECT_THAT(told(warnings), ElementsAre("GROUP_EMPTIED | hub.top+plate.top"));
  EXPECT_THAT(warnings[0].message, testing::HasSubstr("is called plate.top+hub.top now"));
}

TEST(LostNames, FacesOfARemovedFeatureAreToldAtOnce) {
  const Revision original = named(plate(10), {{"hole.bottom"}, {"hole.wall"}, {"plate.top"}});
  const ModelSource model = model_of({block("plate", 20, 20, 4)});
  EXPECT_THAT(told(lost_names(original, named(model, {{"plate.top"}}), kRun)),
              ElementsAre("FACE_LOST hole | hole.bottom hole.wall"));
}

TEST(LostNames, AGroupIsToldWhereItsFacesAreStillThere) {
  const ModelSource model = model_of({block("plate", 20, 20, 4), block("hub", 4, 4, 4)});
  const NameLists apart{{"hub.top"}, {"plate.top"}};
  const Revision original = named(model, {{"hub.top"}, {"hub.top", "plate.top"}, {"plate.top"}});
  EXPECT_THAT(told(lost_names(original, named(model, apart), kRun)),
              ElementsAre("GROUP_EMPTIED | hub.top+plate.top"));
}

TEST(LostNames, WithoutEffectIsSaidOnlyWhereItIsCertain) {
  const auto with = [](const FeatureSource& other, const FeatureSource& last) {
    return model_of({block("plate", 20, 20, 4), other, last});
  };
  const auto unnamed_last = [&](const ModelSource& model) {
    return told(lost_names(
        Revision::none(),
        named(model, {{"plate.top"}, {"other.wall"}}, {{"plate"}, {"other", "plate"}}), kRun));
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
  EXPECT_THAT(
      lost_names(Revision::none(), named(model, kPlate, {{"plate"}, {"plate", "inlay"}}), kRun),
      IsEmpty());
}

TEST(LostNames, AnEditThatMovesAHoleOffAPlateSaysSoInItsReport) {
  const Revision original = make_revision(Revision::none(), plate(10), {.nodes = 300}, kRun);
  EXPECT_THAT(told(lost_names(Revision::none(), original, kRun)), IsEmpty());
  const ModelSource moved = plate(40);
  const Revision remesh = make_revision(original, moved, {}, kRun);
  EXPECT_THAT(told(remesh.report.warnings), testing::IsSupersetOf({"FEATURE_WITHOUT_EFFECT hole |",
                                                                   "FACE_LOST hole | hole.wall"}));
  const Revision fresh = make_revision(Revision::none(), moved, {.nodes = 300}, kRun);
  EXPECT_THAT(told(fresh.report.warnings), testing::Contains("FEATURE_WITHOUT_EFFECT hole |"));
}

/// A remesh of `original`, what was told before there was a mesh, and the stages until then.
struct Watched {
  std::vector<std::string> early;
  std::vector<std::string> stages;
  std::vector<std::string> in_the_report;
};
Watched watched(const Revision& original, const ModelSource& source, bool stop_at_warning) {
  Watched seen;
  remeshd::Run run;
  std::stop_source stop;
  run.stop = stop.get_token();
  run.on_progress = [&](const Progress& p) { seen.stages.emplace_back(p.stage); };
  run.on_warnings = [&](std::span<const Warning> certain) {
    const auto lines = told({certain.begin(), certain.end()});
    seen.early.insert(seen.early.end(), lines.begin(), lines.end());
    if (stop_at_warning) stop.request_stop();
  };
  MeshOptions options;
  if (original.output.mesh.tets.empty()) options.nodes = 300;
  try {
    seen.in_the_report = told(make_revision(original, source, options, run).report.warnings);
  } catch (const Error& e) {
    EXPECT_EQ(e.info().kind, ErrorKind::Cancelled) << e.what();
  }
  return seen;
}

TEST(NamesToBeLost, AreToldBeforeAnythingIsMeshed) {
  const Revision original = make_revision(Revision::none(), plate(10), {.nodes = 300}, kRun);
  const Watched edit = watched(original, plate(40), true);
  EXPECT_THAT(edit.early,
              ElementsAre("FEATURE_WITHOUT_EFFECT hole |", "FACE_LOST hole | hole.wall"));
  EXPECT_THAT(edit.stages, ElementsAre("cells", "difference"));
  const Watched first = watched(Revision::none(), plate(40), true);
  EXPECT_THAT(first.early, ElementsAre("FEATURE_WITHOUT_EFFECT hole |"));
  EXPECT_THAT(first.stages, ElementsAre("cells", "difference"));
}

/// A plate with a hole and an inlay, flush with the top where `raised` is 0.
ModelSource inlaid(double hole_x, double raised) {
  ModelSource model = plate(hole_x);
  model.features.push_back(placed(block("inlay", 4, 4, 2 + raised), -5, -5, 2));
  return model;
}

TEST(NamesToBeLost, AreThoseThatTheMeshLosesForCertain) {
  const ModelSource flush = inlaid(5, 0);
  const Revision original = make_revision(Revision::none(), flush, {.nodes = 400}, kRun);
  ModelSource without = flush;
  without.features.erase(without.features.begin() + 1);
  ModelSource buried = flush;
  buried.features.back().parameters["dz"] = 1.0;
  for (const auto& [what, source, early] :
       std::vector<std::tuple<const char*, ModelSource, std::vector<std::string>>>{
           {"the hole is off the plate",
            inlaid(40, 0),
            {"FEATURE_WITHOUT_EFFECT hole |", "FACE_LOST hole | hole.wall"}},
           {"the hole is gone", without, {"FACE_LOST hole | hole.wall"}},
           {"the inlay stands out", inlaid(5, 2), {"GROUP_EMPTIED | inlay.top+plate.top"}},
           {"the inlay is inside: its material is the mesh's to tell",
            buried,
            {"FACE_LOST inlay | inlay.top"}},
           {"the hole is elsewhere", inlaid(6, 0), {}}}) {
    SCOPED_TRACE(what);
    const Watched seen = watched(original, source, false);
    EXPECT_EQ(seen.early, early);
    for (const std::string& line : seen.early)
      EXPECT_THAT(seen.in_the_report, testing::Contains(line));
  }
}

TEST(LostNames, ASizeThatSelectsNothingAnyMoreIsToldOnce) {
  const auto revision = [](double hole_x, const std::string& on) {
    ModelSource source = plate(hole_x);
    source.sizes = {{"rim", on, 1.0}};
    Revision r = named(source, kPlateWithHole);
    r.cells = build_cells(r.model, kRun);
    return r;
  };
  const Revision there = revision(10, "hole"), gone = revision(90, "hole");
  EXPECT_THAT(told(lost_names(there, there, kRun)), IsEmpty());
  EXPECT_THAT(told(lost_names(there, gone, kRun)), ElementsAre("GROUP_EMPTIED | rim"));
  EXPECT_THAT(told(lost_names(gone, gone, kRun)), IsEmpty());
  EXPECT_THAT(told(names_to_be_lost(there, gone.model, gone.cells.boundary, kRun)),
              testing::Contains("GROUP_EMPTIED | rim"));
}

}  // namespace
}  // namespace remeshd
