#include "engine/plan/copy_plan.h"

#include <gtest/gtest.h>

#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

constexpr double kEdge = 2;

FeatureModel edited(const std::string& original, const std::string& edit) {
  return evaluate(apply(test::case_model(original), test::case_edit(edit)));
}

TEST(CopyPlan, WithoutAnOriginalEverythingIsNew) {
  const CopyPlan source(FeatureModel{}, test::case_features("simple-a"), {kEdge}, kRun);
  EXPECT_EQ(source({0, 0, 20}), CopyPlan::kNew);
  EXPECT_EQ(source({0, 0, 70}), CopyPlan::kOutside);
}

TEST(CopyPlan, AMovedFeatureBringsItsMaterialAlong) {
  const FeatureModel original = test::case_features("simple-a");
  const FeatureModel modified = edited("simple-a", "simple-ab");
  const CopyPlan source(original, modified, {kEdge}, kRun);
  const std::int32_t base = source({0, 0, 20}), top = source({20, 0, 50});
  ASSERT_GE(base, 0);
  ASSERT_GE(top, 0);
  EXPECT_TRUE(source.transforms()[base].is_identity());
  EXPECT_EQ(source.transforms()[top].apply({-20, 0, 50}), (Vec3{20, 0, 50}));
  EXPECT_EQ(source({-20, 0, 50}), CopyPlan::kOutside);
}

TEST(CopyPlan, WhatMovesByLittleIsCopiedWhereItIsIfAskedFor) {
  const FeatureModel original = test::case_features("simple-a");
  const auto transform_at_top = [&](double by, double in_place) {
    const FeatureModel modified =
        evaluate(apply(test::case_model("simple-a"), {{SetParameter{"top_x", -20 + by}}}));
    const CopyPlan source(original, modified, {.edge_length = 4, .in_place = in_place}, kRun);
    const std::int32_t t = source({-20, 0, 50});
    EXPECT_GE(t, 0);
    // Where its wall was is a change if it is within material now that did not come along.
    EXPECT_EQ(source.active_face({-5, 0, 50}, {1, 0, 0}), t == source.identity());
    return source.transforms()[t];
  };
  EXPECT_EQ(transform_at_top(0.5, 0), Transform::translation({0.5, 0, 0}));
  EXPECT_TRUE(transform_at_top(0.5, 1).is_identity());
  EXPECT_EQ(transform_at_top(1.5, 1), Transform::translation({1.5, 0, 0}));
  // A tenth of its least extent is 2.
  EXPECT_EQ(transform_at_top(2.5, 4), Transform::translation({2.5, 0, 0}));
}

TEST(CopyPlan, TellsWhatChangedWithinTheModelInFewBoxes) {
  // What is cut away is a small part of a large block, in two boxes: as it was, and as it is.
  const auto cut = [](double height) {
    return evaluate(test::model_of(
        {test::block("body", 10, 10, 10),
         test::placed(test::block("cutter", 100, 100, 100), 0, 0, height, Nature::Subtractive)}));
  };
  const CopyPlan source(cut(5), cut(4.9), {kEdge}, kRun);
  EXPECT_EQ(source.changed().size(), 2U);
  const Box body{{-5, -5, 0}, {5, 5, 10}};
  const std::vector<Box> within = source.changed_within(body);
  ASSERT_EQ(within.size(), 1U);
  EXPECT_NEAR(within[0].lo.z, 4.9, 1e-3);
  EXPECT_EQ(within[0].hi, body.hi);
  EXPECT_TRUE(source.changed_within({{-5, -5, 0}, {5, 5, 4}}).empty());
  // Two that are apart stay two.
  const auto pins = [](double height) {
    return evaluate(test::model_of({test::block("body", 10, 10, 1),
                                    test::placed(test::cylinder("a", 1, height), -3, 0, 1),
                                    test::placed(test::cylinder("b", 1, height), 3, 0, 1)}));
  };
  EXPECT_EQ(
      CopyPlan(pins(2), pins(3), {kEdge}, kRun).changed_within({{-9, -9, 0}, {9, 9, 9}}).size(),
      2U);
}

TEST(CopyPlan, TheFeatureWithMostToCopyComesFirst) {
  const FeatureModel original = test::case_features("tool2-a");
  const CopyPlan source(original, edited("tool2-a", "tool2-ab"), {kEdge}, kRun);
  ASSERT_FALSE(source.sources().empty());
  EXPECT_EQ(original.features[source.sources().front().original].id, "base");
  for (std::size_t k = 1; k < source.sources().size(); ++k)
    EXPECT_GE(source.sources()[k - 1].volume, source.sources()[k].volume);
}

TEST(CopyPlan, WhereAHoleWasAndIsNoMoreTheMaterialIsNew) {
  const FeatureModel original = test::case_features("fig11-a");
  const CopyPlan source(original, edited("fig11-a", "fig11-ab"), {kEdge}, kRun);
  EXPECT_EQ(source({-26, 0, 7}), CopyPlan::kNew);      // old hole at x -20, radius 8
  EXPECT_EQ(source({-10, 0, 7}), CopyPlan::kOutside);  // new hole at x -10, radius 6
  EXPECT_GE(source({30, 0, 7}), 0);
  EXPECT_GE(source({15, 0, 25}), 0);               // rib as it was
  EXPECT_EQ(source({22, 0, 25}), CopyPlan::kNew);  // rib, widened by 3 on each side
}

TEST(CopyPlan, ACentredReferenceMovesTheCopyWithTheCentre) {
  const FeatureModel original = test::case_features("fig10-a");
  const CopyPlan source(original, edited("fig10-a", "fig10-ab"), {kEdge}, kRun);
  const std::int32_t t = source({0, 0, 19});
  ASSERT_GE(t, 0);
  EXPECT_EQ(source.transforms()[t].apply({0, 0, 16}), (Vec3{0, 0, 19}));
}

TEST(CopyPlan, TheFootOfAMovedRibIsActiveWhereItWasAndWhereItIs) {
  const FeatureModel original = test::case_features("fig6-a");
  const CopyPlan source(original, edited("fig6-a", "fig6-ab"), {kEdge}, kRun);
  const Vec3 up{0, 0, 1};
  EXPECT_TRUE(source.active_face({-20, 0, 10}, up));  // boundary now, was none
  EXPECT_TRUE(source.active_face({10, 0, 10}, up));   // copies of different origin meet
  EXPECT_FALSE(source.active_face({30, 0, 10}, up));  // boundary before and after
  EXPECT_FALSE(source.active_face({30, 0, 5}, up));   // no face at all
  EXPECT_FALSE(source.active_face({10, 8, 22}, up));  // knob on rib: moved together
}

TEST(CopyPlan, ATinyMoveIsStillAMove) {
  ModelSource document = test::case_model("simple-a");
  const FeatureModel original = evaluate(document);
  test::parameter(document, "top_x") = -20 + 1e-7;
  const FeatureModel modified = evaluate(document);
  const CopyPlan source(original, modified, {kEdge}, kRun);
  const std::int32_t top = source({-20, 0, 50});
  ASSERT_GE(top, 0);
  EXPECT_FALSE(source.transforms()[top].is_identity());
  EXPECT_EQ(source.changed().size(), 2U);
}

TEST(CopyPlan, NothingChangedLeavesNoBox) {
  const FeatureModel model = test::case_features("tool1-a");
  EXPECT_TRUE(CopyPlan(model, model, {kEdge}, kRun).changed().empty());
}

TEST(CopyPlan, FeaturesThatMoveTogetherShareATransformation) {
  const FeatureModel original = test::case_features("fig6-a");
  const CopyPlan source(original, edited("fig6-a", "fig6-ab"), {kEdge}, kRun);
  EXPECT_EQ(source.transforms().size(), 2U);
}

TEST(CopyPlan, InARegionToBeMadeAnewEverythingIsNew) {
  const FeatureModel model = test::case_features("simple-a");
  const CopyPlan same(model, model, {kEdge}, kRun);
  EXPECT_EQ(same({0, 0, 20}), same.identity());
  const std::vector<Vec3> places{{0, 0, 20}};
  const CopyPlan plan = same.with_new_in(Region(places, 5, 2));
  EXPECT_EQ(plan({0, 0, 20}), CopyPlan::kNew);
  EXPECT_EQ(plan({0, 0, 70}), CopyPlan::kOutside);
  EXPECT_EQ(plan({12, 0, 20}), plan.identity());
  EXPECT_TRUE(plan.in_changed({0, 0, 20}));
  EXPECT_FALSE(plan.in_changed({12, 0, 20}));
}

TEST(CopyPlan, InARegionToBeMadeAnewInPlaceMovedMaterialIsCopied) {
  const CopyPlan source(test::case_features("fig6-a"), edited("fig6-a", "fig6-ab"), {kEdge}, kRun);
  const Box& box = source.modified().bounds();
  std::vector<Vec3> stays, moves;
  for (int k = 0; k < 20 * 20 * 20; ++k) {
    const Vec3 share{(k % 20 + 0.5) / 20, (k / 20 % 20 + 0.5) / 20, (k / 400 + 0.5) / 20};
    const Vec3 extent = box.hi - box.lo;
    const Vec3 p = box.lo + Vec3{share.x * extent.x, share.y * extent.y, share.z * extent.z};
    const std::int32_t t = source(p);
    if (t >= 0) (t == source.identity() ? stays : moves).push_back(p);
  }
  ASSERT_FALSE(stays.empty());
  ASSERT_FALSE(moves.empty());
  const CopyPlan plan = source.with_new_where(
      [&](const Vec3&, std::int32_t t) { return t == source.identity(); }, {{box}});
  for (const Vec3& p : stays) EXPECT_EQ(plan(p), CopyPlan::kNew);
  for (const Vec3& p : moves) EXPECT_EQ(plan(p), source(p));
}

}  // namespace
}  // namespace remeshd
