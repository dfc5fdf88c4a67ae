#include "engine/model/selection/evaluate_groups.h"

#include <gtest/gtest.h>

#include "engine/model/limits.h"
#include "engine/model/selection/selector.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"

namespace remeshd {
namespace {

ModelSource plate_with_groups(std::vector<GroupSource> groups) {
  ModelSource model = test::model_of({test::block("plate", 60, 40, 8),
                                      test::placed(test::cylinder("hole1", 4, 10), -15, 0, -1),
                                      test::placed(test::cylinder("hole2", 6, 10), 15, 0, -1)});
  model.parameters = {{"high", 5.0}};
  model.groups = std::move(groups);
  return model;
}

/// `reason features parameter`.
std::string refused_groups(std::vector<GroupSource> groups) {
  return test::place_of(test::error_of([&] { evaluate(plate_with_groups(std::move(groups))); }));
}

TEST(Groups, HoldTheFacesOfEachFeatureSelected) {
  const FeatureModel m = evaluate(
      plate_with_groups({{"supports", "hole*.wall", {}}, {"load", "plate & z > high", {0.2}}}));
  ASSERT_EQ(m.groups.size(), 2U);
  EXPECT_EQ(m.groups[0].name, "supports");
  EXPECT_EQ(m.groups[0].on,
            (std::vector<SelectedFaces>{{1, {"wall"}, false, {}}, {2, {"wall"}, false, {}}}));
  EXPECT_EQ(m.groups[1].policy.max_area_change, 0.2);
  ASSERT_EQ(m.groups[1].on.size(), 1U);
  EXPECT_TRUE(m.groups[1].on[0].whole);
  EXPECT_EQ(m.groups[1].on[0].faces.size(), 6U);
  EXPECT_EQ(m.groups[1].on[0].condition.text, "z > high");
}

TEST(Groups, MayNameNothing) {
  EXPECT_TRUE(evaluate(plate_with_groups({{"a", "gone*", {}}})).groups[0].on.empty());
}

TEST(Groups, TellWhatIsWrongWithThem) {
  EXPECT_EQ(refused_groups({{"a b", "plate", {}}}), "INVALID_NAME - groups.a b.name");
  EXPECT_EQ(refused_groups({{"a", "plate", {}}, {"a", "hole1", {}}}), "DUPLICATE_NAME - groups.a");
  EXPECT_EQ(refused_groups({{"hole1", "plate", {}}}), "DUPLICATE_NAME - groups.hole1");
  EXPECT_EQ(refused_groups({{"a", "plate |", {}}}), "SELECTOR_INVALID - groups.a.on");
  EXPECT_EQ(refused_groups({{"a", "plate & w > 2", {}}}), "UNKNOWN_NAME plate groups.a.on");
  EXPECT_EQ(refused_groups({{"a", "plate", {.max_area_change = -0.1}}}),
            "VALUE_OUT_OF_RANGE - groups.a.policy.maxAreaChange");
  EXPECT_EQ(refused_groups(std::vector<GroupSource>(kMaxSelections + 1, {"a", "plate", {}})),
            "LIMIT_EXCEEDED - groups");
}

TEST(Groups, ShareTheLimitOfConditionsWithTheSizes) {
  ModelSource model = plate_with_groups({{"a", "* & z > 1", {}}});
  std::string many = "* & z > 0";
  for (std::size_t k = 1; k < kSelectorLimits.terms; ++k) many += " | * & z > 0";
  for (std::size_t k = 0; k * 3 * kSelectorLimits.terms <= kSelectorLimits.conditions - 3 * 64; ++k)
    model.sizes.push_back({"s" + std::to_string(k), many, 1.0});
  EXPECT_NO_THROW(evaluate(model));
  for (int k = 0; k < 64; ++k) model.groups.push_back({"g" + std::to_string(k), "* & z > 1", {}});
  EXPECT_EQ(test::error_of([&] { evaluate(model); }).reason, "LIMIT_EXCEEDED");
}

}  // namespace
}  // namespace remeshd
