#include "engine/local_fuse/prisms/parallel_prisms.h"
#include "engine/local_fuse/local_fuse.h"

#include <gtest/gtest.h>

#include "engine/base/error.h"
#include "engine/base/random.h"
#include "engine/cellular/cellular_model.h"
#include "engine/local_fuse/sewing/sew.h"
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

FeatureSource slot(std::string id, double length, double width, double height) {
  return feature(std::move(id), "slot", {{"length", length}, {"width", width}, {"height", height}});
}

Tried<FusedPrisms> parts_of(const ModelSource& source) {
  const FeatureModel model = evaluate(source);
  const Membership membership(model);
  FuseFrame frame = fuse_frame(membership);
  frame.reference = membership.bounds().lo;
  return fuse_parallel_prisms(model, membership, all_of(model), frame);
}

TEST(SweptPartsTest, FeaturesAlongOneDirectionNeedNoKernel) {
  for (const char* name : {"simple-a", "tool1-a", "tool1-c", "tool2-a", "tool3-b"})
    EXPECT_TRUE(parts_of(test::case_model(name))) << name;
  // A stiffener that is swept across the pipe.
  EXPECT_EQ(reason_of(parts_of(test::case_model("tool2-d"))),
            "sweeps: no direction is along an axis of every feature");
  EXPECT_EQ(reason_of(parts_of(
                model_of({block("b", 4, 4, 4), feature("s", "sphere", {{"radius", 1.0}})}))),
            "sweeps: a feature is neither a prism nor a cylinder");
}

TEST(SweptPartsTest, ABlockGoesWithEveryDirection) {
  const FeatureSource across = turned(cylinder("c", 1, 10), {1, 0, 0}, {0, 1, 0});
  EXPECT_TRUE(parts_of(model_of({block("b", 6, 6, 6), placed(across, -5, 0, 3)})));
  const FeatureSource tilted = turned(cylinder("c", 1, 10), {1, 1, 0}, {0, 0, 1});
  EXPECT_FALSE(parts_of(model_of({block("b", 6, 6, 6), placed(tilted, -5, 0, 3)})));
}

TEST(SweptPartsTest, WhatIsInDoubtIsLeftToTheKernel) {
  const FeatureSource plate = block("plate", 20, 20, 2);
  const auto with = [&](const FeatureSource& f) {
    return reason_of(parts_of(model_of({plate, f})));
  };
  const std::string meets =
      "planar_arrangement: a round side meets or nearly meets a side of another outline";
  EXPECT_EQ(with(placed(cylinder("pin", 3, 4), 5, 0, 1)), "");
  EXPECT_EQ(with(placed(cylinder("pin", 3, 4), 9, 0, 1)), meets) << "crosses the rim";
  EXPECT_EQ(with(placed(cylinder("pin", 3, 4), 7, 0, 1)), meets) << "touches the rim";
  EXPECT_EQ(with(placed(cylinder("pin", 3, 4), 6.95, 0, 1)), meets) << "chords nearly touch";
  EXPECT_EQ(with(placed(block("step", 20, 4, 4), 0, 0, 2)), "") << "flush";
  EXPECT_EQ(with(placed(block("step", 20, 4, 4), 1e-7, 0, 2)),
            "planar_arrangement: the end of a side nearly touches another side")
      << "nearly flush";
  EXPECT_EQ(with(placed(block("step", 5, 4, 4), 0, 0, 2 - 1e-7)),
            "slabs: two heights are neither clearly the same nor clearly apart")
      << "nearly on top";
}

/// A feature with sizes and places on a coarse grid, so that much is flush.
FeatureSource random_feature(Random& random, const std::string& id) {
  const auto number = [&](int low, int high) {
    return static_cast<double>(low + static_cast<int>(random.below(high - low + 1)));
  };
  FeatureSource f = block(id, 2 * number(1, 6), 2 * number(1, 6), number(1, 6));
  switch (random.below(6)) {
    case 0:
      f = cylinder(id, number(1, 2), number(1, 6));
      break;
    case 1:
      f = slot(id, number(4, 6), number(1, 2), number(1, 6));
      break;
    case 2:
      f = feature(id, "prism",
                  {point(0., 0.), point(6., 0.), point(6., 2.), point(2., 2.), point(1., 5.),
                   point(0., 5.)},
                  {{"height", number(1, 6)}});
      break;
    default:
      break;
  }
  f = placed(f, number(-5, 5), number(-5, 5), number(0, 4),
             random.below(3) == 0 ? Nature::Subtractive : Nature::Additive);
  switch (random.below(6)) {
    case 0:
      return turned(f, {0, 0, -1}, {1, 0, 0});
    case 1:
      return turned(f, {0, 0, 1}, {0.6, 0.8, 0});
    case 2:
      return turned(f, {0, 0, 1}, {0, -1, 0});
    default:
      return f;
  }
}

TEST(SweptPartsTest, RandomModelsAreWhatTheKernelMakesOfThem) {
  Random random(5);
  int compared = 0;
  for (int k = 0; k < 120 && compared < 25; ++k) {
    ModelSource source = model_of({block("base", 24, 20, 3)});
    for (int f = 0; f < 4; ++f)
      source.features.push_back(random_feature(random, "f" + std::to_string(f)));
    ModelSource edited = source;
    edited.features[1 + random.below(4)] = random_feature(random, "other");
    try {
      const FeatureModel base = evaluate(source), model = evaluate(edited);
      const Membership membership(model);
      const CellularModel cells = build_cells(base, kRun);
      FuseFrame frame = fuse_frame(membership);
      frame.reference = cells.parts->brep.reference;
      if (!fuse_parallel_prisms(model, membership, all_of(model), frame)) continue;
      const CellularModel whole = build_cells(model, kRun);
      EXPECT_TRUE(sew({model, membership}, {base, *cells.parts}, kRun).parts) << k;
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
