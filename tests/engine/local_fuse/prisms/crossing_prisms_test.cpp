#include "engine/local_fuse/prisms/crossing_prisms.h"
#include "engine/local_fuse/local_fuse.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/error.h"
#include "engine/base/random.h"
#include "engine/cellular/cellular_model.h"
#include "engine/local_fuse/sewing/sew.h"
#include "tests/support/large_models.h"
#include "tests/support/local_fuse.h"
#include "tests/support/run.h"
#include "tests/support/same_boundary.h"

namespace remeshd {
namespace {

using test::kRun;

using test::all_of;
using test::block;
using test::cylinder;
using test::feature;
using test::model_of;
using test::placed;
using test::point;
using test::reason_of;
using test::turned;

Tried<FusedPrisms> crossing_parts_of(const FeatureModel& model) {
  const Membership membership(model);
  FuseFrame frame = fuse_frame(membership);
  frame.reference = membership.bounds().lo;
  return fuse_crossing_prisms(model, membership, all_of(model), frame);
}

/// The boundary of a model all of whose features changed, beside what the kernel makes of it.
void expect_what_the_kernel_makes(const ModelSource& source, const std::string& what) {
  ModelSource other = source;
  for (FeatureSource& f : other.features) f.id += "_before";
  const FeatureModel model = evaluate(source);
  const CellularModel whole = build_cells(model, kRun);
  const auto parts = sew({model, Membership(model)}, {evaluate(other), *whole.parts}, kRun).parts;
  ASSERT_TRUE(parts) << what;
  EXPECT_EQ(test::difference_of(whole, restore_cells(model, *parts)), "") << what;
}

TEST(CrossedPartsTest, AStiffenerAcrossAPipeNeedsNoKernel) {
  EXPECT_TRUE(crossing_parts_of(test::case_features("tool2-d")));
  expect_what_the_kernel_makes(test::case_model("tool2-d"), "tool2-d");
}

TEST(CrossedPartsTest, PlanesCutRoundWallsInLinesCirclesAndEllipses) {
  const FeatureSource pipe = cylinder("pipe", 4, 10);
  const auto check = [&](const FeatureSource& f, int others) {
    const ModelSource source = model_of({pipe, f});
    const FeatureModel model = evaluate(source);
    EXPECT_TRUE(crossing_parts_of(model)) << f.type;
    expect_what_the_kernel_makes(source, f.type);
    int ellipses = 0;
    for (const BoundaryEdge& edge : build_cells(model, kRun).boundary.edges)
      ellipses += edge.curve.kind == Curve::Kind::Other ? 1 : 0;
    EXPECT_EQ(ellipses, others);
  };
  check(placed(block("across", 20, 2, 3), 0, 0, 4), 0);
  check(placed(cylinder("beside", 2, 6), 4, 0, 2), 0);
  // Cut off askew, and a slot askew through the wall.
  check(placed(turned(block("above", 30, 30, 9), {0.6, 0, 0.8}, {0.8, 0, -0.6}), 0, 0, 6,
               Nature::Subtractive),
        1);
  check(placed(turned(block("askew", 2, 2, 20), {0.8, 0, 0.6}, {0.6, 0, -0.8}), -8, 0, -1,
               Nature::Subtractive),
        4);
}

TEST(CrossedPartsTest, PointsOfCirclesAndArcsTurnByAtMostSixDegrees) {
  const auto parts = crossing_parts_of(
      evaluate(model_of({cylinder("pipe", 4, 10), placed(block("across", 20, 2, 3), 0, 0, 4)})));
  int circles = 0;
  for (const kernel::BrepEdge& edge : parts->parts.brep.edges) {
    if (edge.kind != kernel::BrepEdge::Kind::Circle) continue;
    ++circles;
    EXPECT_LT(test::largest_turning(edge), 6.01) << edge.length;
  }
  EXPECT_GE(circles, 6) << "two ends of the pipe, and four arcs where the block comes out";
}

TEST(CrossedPartsTest, WhatIsInDoubtIsLeftToTheKernel) {
  const auto with = [](const FeatureSource& f) {
    return reason_of(crossing_parts_of(evaluate(model_of({cylinder("pipe", 4, 10), f}))));
  };
  const std::string side =
      "intersection_curves: a plane touches or nearly touches a cylinder along its side";
  EXPECT_EQ(with(placed(block("fin", 10, 2, 3), 5, 0, 4)), "");
  EXPECT_EQ(with(placed(block("fin", 10, 2, 3), 5, 3, 4)), side) << "a side touches the wall";
  EXPECT_EQ(with(placed(block("fin", 10, 2, 3), 5, 2.95, 4)), side) << "a side nearly touches";
  EXPECT_EQ(with(placed(block("fin", 10, 2, 3), 8.95, 0, 4)), side) << "an end nearly inside";
  EXPECT_EQ(with(placed(block("fin", 10, 2, 3), 5, 0, 7 - 1e-5)),
            "intersection_curves: two parallel planes are neither clearly the same nor clearly "
            "apart");
  EXPECT_EQ(with(turned(cylinder("tee", 2, 10), {1, 0, 0}, {0, 1, 0})),
            "intersection_curves: two cylinders meet or nearly meet whose axes are not parallel");
  EXPECT_EQ(with(placed(cylinder("beside", 2, 6), 6, 0, 2)),
            "intersection_curves: two parallel cylinders touch or nearly touch");
  EXPECT_EQ(with(turned(block("fin", 1, 1, 20), {0.05, 0, 1}, {1, 0, -0.05})),
            "intersection_curves: a plane meets the axis of a cylinder at a small angle");
  EXPECT_EQ(with(feature("ball", "sphere", {{"radius", 3.0}})),
            "sweeps: a feature is neither a prism nor a cylinder");
}

TEST(CrossedPartsTest, AVertexNearACylinderIsLeftToTheKernel) {
  // A corner of the block points to the pipe's axis.
  const auto with_corner_at = [](double x) {
    const double half_diagonal = std::sqrt(8.0);
    return reason_of(crossing_parts_of(evaluate(
        model_of({cylinder("pipe", 4, 10), placed(turned(block("b", 4, 4, 3), {0, 0, 1}, {1, 1, 0}),
                                                  x + half_diagonal, 0, 4)}))));
  };
  EXPECT_EQ(with_corner_at(3), "");
  for (const double x : {3.95, 4.05})
    EXPECT_EQ(with_corner_at(x), "crossing_prisms: a vertex lies near a cylinder but not on it")
        << x;
}

TEST(CrossedPartsTest, MoreFeaturesThanASetHoldsAreLeftToTheKernel) {
  EXPECT_EQ(reason_of(crossing_parts_of(evaluate(test::row_of_blocks(65)))),
            "crossing_prisms: there are too many features");
}

/// A feature with sizes and places on a coarse grid or off it, along one of many directions.
FeatureSource random_crossing_feature(Random& random, const std::string& id, bool flush) {
  const auto number = [&](int low, int high) {
    return static_cast<double>(low + static_cast<int>(random.below(high - low + 1))) +
           (flush ? 0.0 : random.uniform(-0.4, 0.4));
  };
  FeatureSource f = block(id, 2 * number(1, 6), 2 * number(1, 6), number(1, 6));
  switch (random.below(5)) {
    case 0:
    case 1:
      f = cylinder(id, number(1, 3), number(1, 8));
      break;
    case 2:
      f = feature(id, "slot",
                  {{"length", number(4, 6)}, {"width", number(1, 2)}, {"height", number(1, 6)}});
      break;
    case 3:
      f = feature(id, "prism", {point(0., 0.), point(number(4, 8), 0.), point(0., number(3, 7))},
                  {{"height", number(1, 6)}});
      break;
    default:
      break;
  }
  f = placed(f, number(-8, 8), number(-7, 7), number(0, 6),
             random.below(3) == 0 ? Nature::Subtractive : Nature::Additive);
  switch (random.below(8)) {
    case 0:
      return turned(f, {1, 0, 0}, {0, 1, 0});
    case 1:
      return turned(f, {0, -1, 0}, {1, 0, 0});
    case 2:
      return turned(f, {0.6, 0, 0.8}, {0, 1, 0});
    case 3:
      return turned(f, {0, 0, 1}, {0.6, 0.8, 0});
    default:
      return f;
  }
}

TEST(CrossedPartsTest, RandomModelsAreWhatTheKernelMakesOfThem) {
  Random random(3);
  int compared = 0;
  for (int k = 0; k < 400 && compared < 25; ++k) {
    ModelSource source = model_of({block("base", 24, 20, 3)});
    for (int f = 0; f < 4; ++f)
      source.features.push_back(
          random_crossing_feature(random, "f" + std::to_string(f), k % 2 == 0));
    ModelSource edited = source;
    edited.features[1 + random.below(4)] = random_crossing_feature(random, "other", k % 2 == 0);
    try {
      const FeatureModel base = evaluate(source), model = evaluate(edited);
      if (!crossing_parts_of(model)) continue;
      const CellularModel cells = build_cells(base, kRun), whole = build_cells(model, kRun);
      expect_what_the_kernel_makes(edited, std::to_string(k));
      EXPECT_EQ(test::difference_of(whole, build_cells(model, base, cells, kRun)), "") << k;
      ++compared;
    } catch (const Error&) {
      continue;  // not in one piece, or touching itself
    }
  }
  EXPECT_EQ(compared, 25);
}

}  // namespace
}  // namespace remeshd
