#include "engine/model/selection/evaluate_sizes.h"

#include <gtest/gtest.h>

#include "engine/model/limits.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"

namespace remeshd {
namespace {

using Faces = std::vector<std::string>;
using Selected = std::vector<SizedFaces>;

/// A plate, two holes of different radii and a slot.
ModelSource model(std::vector<SizeControlSource> sizes) {
  FeatureSource slot = test::feature("slot", "slot", {{"length", 9.0}, {"width", 4.0}});
  slot.parameters["height"] = 3.0;
  ModelSource model = test::model_of(
      {test::block("plate", 60, 40, 8), test::placed(test::cylinder("hole1", 4, 10), -15, 0, -1),
       test::placed(test::cylinder("hole2", 6, 10), 15, 0, -1), slot});
  model.parameters = {{"fine", 0.5}, {"radius", 100.0}};
  model.sizes = std::move(sizes);
  return model;
}

SizeControl evaluated(const SizePlaceSource& place, const Scalar& size) {
  return evaluate(model({{"a", place, size}})).sizes.at(0);
}

Selected selected(const std::string& on, const Scalar& size) {
  return std::get<Selected>(evaluated(on, size).place);
}

/// `reason features parameter`.
std::string refused(const SizePlaceSource& place, const Scalar& size) {
  return test::place_of(test::error_of([&] { evaluated(place, size); }));
}

TEST(Sizes, OfAModelWithoutAnyAreNone) { EXPECT_TRUE(evaluate(model({})).sizes.empty()); }

TEST(Sizes, KeepTheirOrderAndIds) {
  const FeatureModel m = evaluate(model({{"b", "plate", 1.0}, {"a", "plate", 2.0}}));
  ASSERT_EQ(m.sizes.size(), 2U);
  EXPECT_EQ(m.sizes[0].id, "b");
  EXPECT_EQ(m.sizes[1].id, "a");
}

TEST(Sizes, OnFacesHoldTheFacesOfEachFeatureSelected) {
  EXPECT_EQ(selected("hole*.wall", 1.5),
            (Selected{{{1, {"wall"}, false, {}}, 1.5}, {{2, {"wall"}, false, {}}, 1.5}}));
  EXPECT_EQ(
      selected("hole2 | plate.top", 1.5),
      (Selected{{{0, {"top"}, false, {}}, 1.5}, {{2, {"wall", "bottom", "top"}, true, {}}, 1.5}}));
  EXPECT_EQ(selected("slot.wall", 1.5), (Selected{{{3, {"wall"}, false, {}}, 1.5}}))
      << "each face once";
  EXPECT_EQ(selected("gone*", 1.5), Selected());
}

TEST(Sizes, OnFacesSeeTheFeaturesParametersBeforeTheModels) {
  EXPECT_EQ(selected("hole*.wall", "radius/4"),
            (Selected{{{1, {"wall"}, false, {}}, 1.0}, {{2, {"wall"}, false, {}}, 1.5}}));
  EXPECT_EQ(selected("hole1.wall", "fine * height"), (Selected{{{1, {"wall"}, false, {}}, 5.0}}));
  EXPECT_EQ(selected("plate.top", "radius/4"), (Selected{{{0, {"top"}, false, {}}, 25.0}}));
}

TEST(Sizes, OnFacesSeeWhatAFeatureLeavesToItsType) {
  ModelSource source = model({{"a", "ring", "angle/360"}});
  source.features.push_back(
      test::feature("ring", "revolution",
                    {test::point(1.0, 0.0), test::point(2.0, 0.0), test::point(1.0, 2.0)}, {}));
  EXPECT_EQ(std::get<Selected>(evaluate(source).sizes[0].place).at(0).size, 1);
}

TEST(Sizes, OnFacesUnderAConditionStandBesideThoseWithout) {
  const Selected two = selected("hole*.wall & z > height/2 | plate.top | hole2.top", "fine");
  ASSERT_EQ(two.size(), 4U);
  const OpenExpression condition{"z > height/2", {{"height", 10}}};
  EXPECT_EQ(two[0], (SizedFaces{{0, {"top"}, false, {}}, 0.5}));
  EXPECT_EQ(two[1], (SizedFaces{{1, {"wall"}, false, condition}, 0.5}));
  EXPECT_EQ(two[2], (SizedFaces{{2, {"top"}, false, {}}, 0.5}));
  EXPECT_EQ(two[3], (SizedFaces{{2, {"wall"}, false, condition}, 0.5}));
}

TEST(Sizes, ConditionsSeeThePlaceBeforeAnyParameter) {
  ModelSource source = model({{"a", "plate.top & x > y + fine", 1.0}});
  source.parameters.push_back({"x", 100.0});
  const Selected on = std::get<Selected>(evaluate(source).sizes.at(0).place);
  EXPECT_EQ(on.at(0).on.condition, (OpenExpression{"x > y + fine", {{"fine", 0.5}}}));
  ConditionTest test(on[0].on.condition);
  EXPECT_TRUE(test({2, 1, 0}, {0, 0, 1}));
  EXPECT_FALSE(test({1.4, 1, 0}, {0, 0, 1}));
}

TEST(Sizes, InPartsOfSpaceSeeTheModelsParameters) {
  const SizedBall ball =
      std::get<SizedBall>(evaluated(BallSource{1.0, "2*fine", 3.0, "fine + 4"}, "fine/2").place);
  EXPECT_EQ(ball, (SizedBall{{1, 1, 3}, 4.5, 0.25}));
  const SizedBox box =
      std::get<SizedBox>(evaluated(BoxSource{0.0, 0.0, 0.0, 1.0, "2", "radius"}, 0.5).place);
  EXPECT_EQ(box, (SizedBox{{0, 0, 0}, {1, 2, 100}, 0.5}));
}

TEST(Sizes, ThatAreWrongAreNamedWithTheirField) {
  const BallSource ball{0.0, 0.0, 0.0, 1.0};
  for (const double size : {0.0, -1.0, 1e-12, 1e12}) {
    EXPECT_EQ(refused("plate", size), "VALUE_OUT_OF_RANGE - sizes.a.size");
    EXPECT_EQ(refused("gone", size), "VALUE_OUT_OF_RANGE - sizes.a.size");
    EXPECT_EQ(refused(ball, size), "VALUE_OUT_OF_RANGE - sizes.a.size");
  }
  EXPECT_EQ(refused("hole*", "4 - radius"), "VALUE_OUT_OF_RANGE hole1 sizes.a.size");
  EXPECT_EQ(refused("plate", "nope"), "UNKNOWN_NAME plate sizes.a.size");
  EXPECT_EQ(refused("plate | hole1", "dx"), "UNKNOWN_NAME hole1 sizes.a.size");
  EXPECT_EQ(refused("plate", "1/0"), "NON_FINITE_VALUE plate sizes.a.size");
  EXPECT_EQ(refused("plate", "1, 2"), "INVALID_EXPRESSION plate sizes.a.size");
  EXPECT_EQ(refused(ball, "height"), "UNKNOWN_NAME - sizes.a.size");
  EXPECT_EQ(refused("a b", 1.0), "SELECTOR_INVALID - sizes.a.on");
  EXPECT_EQ(refused("hole* & z > depth", 1.0), "UNKNOWN_NAME hole1 sizes.a.on");
  EXPECT_EQ(refused("plate & z >", 1.0), "INVALID_EXPRESSION plate sizes.a.on");
  EXPECT_EQ(refused("plate & x, y", 1.0), "INVALID_EXPRESSION plate sizes.a.on");
  EXPECT_EQ(refused("plate & z = 1", 1.0), "INVALID_EXPRESSION plate sizes.a.on");
  EXPECT_EQ(refused(BallSource{0.0, "q", 0.0, 1.0}, 1.0), "UNKNOWN_NAME - sizes.a.in.ball[1]");
  EXPECT_EQ(refused(BallSource{0.0, 0.0, 0.0, 0.0}, 1.0),
            "VALUE_OUT_OF_RANGE - sizes.a.in.ball[3]");
  EXPECT_EQ(refused(BallSource{0.0, 0.0, 1e10, 1.0}, 1.0),
            "VALUE_OUT_OF_RANGE - sizes.a.in.ball[2]");
  EXPECT_EQ(refused(BoxSource{0.0, 0.0, 0.0, 1.0, 0.0, 1.0}, 1.0),
            "VALUE_OUT_OF_RANGE - sizes.a.in.box[4]");
}

TEST(Sizes, HaveNamesOfTheirOwn) {
  const auto of = [](std::vector<SizeControlSource> sizes) {
    return test::place_of(test::error_of([&] { evaluate(model(std::move(sizes))); }));
  };
  EXPECT_EQ(of({{"a", "plate", 1.0}, {"a", "hole1", 1.0}}), "DUPLICATE_NAME - sizes.a.id");
  EXPECT_EQ(of({{"a", "plate", 1.0}, {"", "plate", 1.0}}), "INVALID_NAME - sizes[1].id");
  EXPECT_EQ(of({{"pi", "plate", 1.0}}), "INVALID_NAME - sizes[0].id");
}

TEST(Sizes, AreNotTooMany) {
  std::vector<SizeControlSource> many(kMaxSelections + 1, {"a", "plate", 1.0});
  EXPECT_EQ(test::error_of([&] { evaluate(model(many)); }).reason, "LIMIT_EXCEEDED");
}

TEST(Sizes, DoNotAskTooMuchOfTheirSelectors) {
  std::string terms = "plate";
  for (int k = 1; k < 64; ++k) terms += "|plate";
  std::vector<SizeControlSource> sizes;
  for (int k = 0; k < 80; ++k) sizes.push_back({"s" + std::to_string(k), terms, 1.0});
  ModelSource source = model(std::move(sizes));
  EXPECT_NO_THROW(evaluate(source));
  for (int k = 0; k < 200; ++k)
    source.features.push_back(test::block("more" + std::to_string(k), 1, 1, 1));
  EXPECT_EQ(test::error_of([&] { evaluate(source); }).reason, "LIMIT_EXCEEDED");
}

TEST(Sizes, DoNotHaveTooManyConditions) {
  std::string terms = "*&x>1";
  for (int k = 1; k < 64; ++k) terms += "|*&x>1";
  ModelSource source = model({});
  for (int k = 0; k < 36; ++k)
    source.features.push_back(test::block("more" + std::to_string(k), 1, 1, 1));
  for (int k = 0; k < 3; ++k) source.sizes.push_back({"s" + std::to_string(k), terms, 1.0});
  EXPECT_NO_THROW(evaluate(source)) << "3 x 64 x 40";
  source.sizes.push_back({"s3", terms, 1.0});
  const ErrorInfo info = test::error_of([&] { evaluate(source); });
  EXPECT_EQ(test::place_of(info), "LIMIT_EXCEEDED - sizes.s3.on");
}

}  // namespace
}  // namespace remeshd
