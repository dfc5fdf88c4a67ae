#include "engine/delivery/group_areas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

TEST(GroupAreas, LeaveOutWhatIsElsewhereInTheSamePlane) {
  const FeatureModel model = evaluate(test::model_of(
      {test::block("base", 120, 70, 12), test::placed(test::block("one", 20, 20, 30), -40, 0, 12),
       test::placed(test::block("beside", 10, 20, 30), -25, 0, 12),
       test::placed(test::block("far", 20, 20, 30), 40, 0, 12)}));
  const auto areas = group_areas({}, {}, model, Membership(model), build_cells(model, test::kRun));
  const auto exact = [&](const std::string& group) {
    const auto at = std::ranges::find(areas, group, &GroupArea::group);
    return at == areas.end() ? 0.0 : at->exact_area;
  };
  EXPECT_NEAR(exact("one.top"), 400, 1e-6);
  EXPECT_NEAR(exact("beside.top"), 200, 1e-6);
}

}  // namespace
}  // namespace remeshd
