#include "tests/campaign/parts/part_goals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace remeshd::campaign {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Outcome valid(std::size_t step, double seconds) {
  return {.step = step,
          .kind = "valid",
          .strategy = "local",
          .processor_seconds = seconds,
          .kept = 0.8,
          .away_angle = 20};
}

WorkedCase worked(std::vector<Outcome> outcomes) {
  WorkedCase result;
  result.campaign_case.seed = 3;
  result.campaign_case.number = 14;
  result.campaign_case.part = "valve";
  result.campaign_case.steps = {{{}, "drift"}, {{}, "jump"}, {{}, "move"}};
  result.outcomes = std::move(outcomes);
  return result;
}

PartFigures figures(std::vector<Outcome> outcomes) {
  PartFigures result;
  result.add(worked(std::move(outcomes)));
  return result;
}

TEST(PartFigures, CountEditsAloneByTheFirstMeshOfTheirPart) {
  const PartFigures f = figures({valid(0, 2), valid(1, 0.5), valid(2, 1), valid(3, 7)});
  EXPECT_EQ(f.edits, 3);
  EXPECT_EQ(f.meshes, 3);
  EXPECT_THAT(f.times, ElementsAre(0.25, 0.5, 3.5));
  EXPECT_DOUBLE_EQ(f.median_time(), 0.5);
  EXPECT_DOUBLE_EQ(f.most_time(), 3.5);
  EXPECT_THAT(f.misses.at("slow"), ElementsAre("valve 3-14-3 (move): 3.5 first meshes, local"));
}

TEST(PartFigures, TellEachRefusalByNameAndPlace) {
  Outcome refused{.step = 1,
                  .kind = "refused",
                  .reason = "BOUNDARY_NOT_RECOVERED",
                  .message = "no mesh at (1, 2, 3) [bleed]"};
  const PartFigures f = figures({valid(0, 1), refused});
  EXPECT_EQ(f.refused, 1);
  EXPECT_EQ(f.meshes, 0);
  EXPECT_THAT(
      f.misses.at("refused"),
      ElementsAre("valve 3-14-1 (drift): BOUNDARY_NOT_RECOVERED: no mesh at (1, 2, 3) [bleed]"));
}

TEST(PartFigures, TellTetGenOfTheWholeFromALastResortElsewhere) {
  Outcome whole = valid(1, 1), part = valid(2, 1);
  whole.strategy = "TetGen";
  whole.last_resort = 1;
  part.last_resort = 0.25;
  part.newly_last_resort = 0.22;
  Outcome keeps = valid(3, 1);
  keeps.last_resort = 0.25;
  const PartFigures f = figures({valid(0, 1), whole, part, keeps});
  EXPECT_EQ(f.tetgen, 1);
  EXPECT_EQ(f.with_last_resort, 1);
  EXPECT_DOUBLE_EQ(f.last_resort, 0.5);
  EXPECT_DOUBLE_EQ(f.most_last_resort, 0.22);
  EXPECT_THAT(f.misses.at("last resort of many tets"),
              ElementsAre("valve 3-14-2 (jump): 0.22, local"));
}

TEST(PartFigures, CountEditsThatLostNodesFarFromAChange) {
  Outcome near = valid(1, 1), far = valid(2, 1);
  near.lost = {.all = 900};
  far.lost = {.all = 900, .far = 2, .furthest = 7.5};
  const PartFigures f = figures({valid(0, 1), near, far});
  EXPECT_EQ(f.far_lost, 1);
  EXPECT_EQ(f.far_lost_by_way.at("local"), 1);
  EXPECT_DOUBLE_EQ(f.furthest, 7.5);
}

TEST(PartFigures, KnowInvalidMeshesCrashesAndHangs) {
  const PartFigures f = figures({valid(0, 1),
                                 {.step = 1, .kind = "invalid", .reason = "volume"},
                                 {.step = 2, .kind = "crash", .reason = "Aborted"},
                                 {.step = 3, .kind = "hang", .reason = "time"}});
  EXPECT_EQ(f.invalid, 1);
  EXPECT_EQ(f.crashes, 1);
  EXPECT_EQ(f.hangs, 1);
  EXPECT_EQ(f.edits, 3);
  EXPECT_EQ(f.meshes, 0);
}

TEST(PartFigures, TakeTheLeastAngleOfEdits) {
  Outcome first = valid(0, 1), worse = valid(2, 1);
  first.away_angle = 3;
  worse.away_angle = 12;
  EXPECT_DOUBLE_EQ(figures({first, valid(1, 1), worse, valid(3, 1)}).away_angle, 12);
}

TEST(PartFigures, LeaveOutCasesOfNoPart) {
  WorkedCase other = worked({valid(0, 1), valid(1, 1)});
  other.campaign_case.part.clear();
  PartFigures f;
  f.add(other);
  EXPECT_EQ(f.edits, 0);
}

TEST(PartFigures, ArePrintedBesideTheirGoals) {
  std::ostringstream out;
  print(figures({valid(0, 2), valid(1, 0.5)}), out);
  EXPECT_THAT(out.str(), HasSubstr("valve 1"));
  EXPECT_THAT(out.str(), HasSubstr("median 0.25, most 0.25"));
  EXPECT_THAT(out.str(), HasSubstr("goal: median .3, none over 3"));
}

}  // namespace
}  // namespace remeshd::campaign
