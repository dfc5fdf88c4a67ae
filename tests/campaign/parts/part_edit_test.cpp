#include "tests/campaign/parts/part_edit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/support/cases.h"

namespace remeshd::campaign {
namespace {

std::vector<std::string> names(const ModelSource& part, const std::vector<int>& features) {
  std::vector<std::string> result;
  for (const int f : features) result.push_back(part.features[f].id);
  return result;
}

std::vector<ChangeSteps> many_changes(const ModelSource& part, Change change) {
  Random random(1);
  int serial = 0;
  std::vector<ChangeSteps> result;
  for (int k = 0; k < 20; ++k) result.push_back(random_change(part, change, random, serial));
  return result;
}

TEST(Patterns, AreFeaturesOfTheSameMeasurementsAndStem) {
  const ModelSource carrier = test::case_model("detailed/carrier");
  std::map<std::string, std::size_t> sizes;
  for (const std::vector<int>& pattern : patterns(carrier))
    sizes[carrier.features[pattern.front()].id] = pattern.size();
  const std::map<std::string, std::size_t> expected{{"disc", 1},     {"hub", 1},   {"bore", 1},
                                                    {"spline0", 12}, {"win0", 3},  {"pin0", 3},
                                                    {"dowel0", 3},   {"groove", 1}};
  EXPECT_EQ(sizes, expected);
}

TEST(Patterns, GoOverWholeCirclesAndKeepOtherNamesApart) {
  ModelSource part = test::case_model("detailed/valve");
  std::size_t largest = 0;
  for (const std::vector<int>& pattern : patterns(part))
    largest = std::max(largest, pattern.size());
  EXPECT_EQ(largest, 12U);
  const std::size_t before = patterns(part).size();
  part.features.back().id = "drain";
  EXPECT_EQ(patterns(part).size(), before + 1);
}

TEST(WhatAFeatureCarries, AreSmallerOnesOnItsAxis) {
  const ModelSource carrier = test::case_model("detailed/carrier");
  const FeatureModel model = evaluate(carrier);
  const auto carried = [&](const char* id) {
    return names(carrier, with_what_it_carries(model, model.index_of(id)));
  };
  EXPECT_EQ(carried("pin1"), (std::vector<std::string>{"pin1", "dowel1"}));
  EXPECT_EQ(carried("dowel1"), (std::vector<std::string>{"dowel1"}));
  EXPECT_EQ(carried("hub"), (std::vector<std::string>{"hub", "bore"}));
}

TEST(RandomChange, DriftsInSmallStepsTheSameWay) {
  const ModelSource part = test::case_model("detailed/mount");
  for (const ChangeSteps& steps : many_changes(part, Change::Drift)) {
    EXPECT_GE(steps.edits.size(), 3U);
    EXPECT_LE(steps.edits.size(), 5U);
    EXPECT_EQ(steps.edits.size(), steps.sizes.size());
    for (const double size : steps.sizes) {
      EXPECT_GT(size, 0);
      EXPECT_LT(size, 0.03);
    }
  }
}

TEST(RandomChange, SweepsOneParameterInEvenSteps) {
  const ModelSource part = test::case_model("detailed/mount");
  int numbers = 0;
  for (const ChangeSteps& steps : many_changes(part, Change::Sweep)) {
    EXPECT_GE(steps.edits.size(), 4U);
    EXPECT_LE(steps.edits.size(), 6U);
    std::vector<double> values;
    for (const ModelEdit& edit : steps.edits)
      if (const auto* set = std::get_if<SetFeatureParameter>(&edit.edits.front()))
        if (const auto* value = std::get_if<Scalar>(&set->value))
          values.push_back(std::get<double>(*value));
    if (values.empty()) continue;
    ++numbers;
    for (std::size_t k = 2; k < values.size(); ++k)
      EXPECT_NEAR(values[k] - values[k - 1], values[1] - values[0], 1e-9);
  }
  EXPECT_GT(numbers, 5);
}

TEST(RandomChange, AddsWhatIsLikeSomethingThere) {
  const ModelSource part = test::case_model("detailed/carrier");
  for (const ChangeSteps& steps : many_changes(part, Change::Addition)) {
    ASSERT_EQ(steps.edits.size(), 1U);
    const ModelSource larger = apply(part, steps.edits.front());
    EXPECT_GT(larger.features.size(), part.features.size());
    EXPECT_NO_THROW(evaluate(larger));
  }
}

TEST(RandomChange, RemovesNoBody) {
  const ModelSource part = test::case_model("detailed/mount");
  for (const ChangeSteps& steps : many_changes(part, Change::Removal)) {
    const FeatureModel smaller = evaluate(apply(part, steps.edits.front()));
    EXPECT_LT(smaller.features.size(), part.features.size());
    EXPECT_GE(smaller.index_of("foot"), 0);
    EXPECT_GE(smaller.index_of("back"), 0);
  }
}

}  // namespace
}  // namespace remeshd::campaign
