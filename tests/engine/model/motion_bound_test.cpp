#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/base/random.h"
#include "engine/model/feature_model.h"
#include "engine/model/solid.h"
#include "tests/support/cases.h"

namespace remeshd {
namespace {

using test::arc;
using test::point;

/// One feature of each type, for a model about 100 across: the tolerance is about 1e-10.
ModelSource original() {
  ModelSource model =
      test::one_feature(test::feature("base", "block", {{"dx", 60.0}, {"dy", 60.0}, {"dz", 60.0}}));
  model.features.push_back(test::feature("pin", "cylinder", {{"radius", 4.0}, {"height", 9.0}}));
  model.features.push_back(
      test::feature("tip", "cone", {{"radius_bottom", 4.0}, {"radius_top", 2.0}, {"height", 9.0}}));
  model.features.push_back(test::feature("ball", "sphere", {{"radius", 4.0}}));
  model.features.push_back(
      test::feature("tyre", "torus", {{"major_radius", 8.0}, {"minor_radius", 2.0}}));
  model.features.push_back(test::feature(
      "web", "prism", {point(0.0, 0.0), point(9.0, 0.0), arc(9.0, 9.0, 10.0, 4.0), point(0.0, 9.0)},
      {{"height", 9.0}}));
  model.features.push_back(test::feature("arch", "revolution",
                                         {point(5.0, 0.0), point(9.0, 0.0), point(9.0, 4.0)},
                                         {{"angle", 90.0}}));
  model.features.push_back(
      test::feature("key", "slot", {{"length", 9.0}, {"width", 4.0}, {"height", 3.0}}));
  return model;
}

bool same(const ModelSource& a, const ModelSource& b) {
  return same_geometry(evaluate(a), evaluate(b)) && same_geometry(evaluate(b), evaluate(a));
}

double bound(const ModelSource& a, const ModelSource& b) {
  const double motion = motion_bound(evaluate(a), evaluate(b));
  EXPECT_EQ(motion, motion_bound(evaluate(b), evaluate(a)));
  return motion;
}

/// The original with each parameter, each coordinate of a profile and each placement changed in
/// turn by about 0.1.
std::vector<ModelSource> changes() {
  std::vector<ModelSource> all;
  const auto changed = [&](const auto& change) { change(all.emplace_back(original())); };
  const std::size_t features = original().features.size();
  for (std::size_t f = 0; f < features; ++f) {
    const FeatureSource feature = original().features[f];
    for (const auto& [name, value] : feature.parameters)
      for (const double by : {-0.1, 0.1})
        changed([&](ModelSource& model) {
          model.features[f].parameters[name] =
              std::get<double>(value) + (name == "angle" ? 10 * by : by);
        });
    for (std::size_t k = 0; feature.profile && k < feature.profile->size(); ++k) {
      changed([&](ModelSource& m) {
        (*m.features[f].profile)[k].x = 0.1 + std::get<double>((*feature.profile)[k].x);
      });
      changed([&](ModelSource& m) {
        (*m.features[f].profile)[k].y = 0.1 + std::get<double>((*feature.profile)[k].y);
      });
    }
    changed([&](ModelSource& m) { m.features[f].placement.origin[1] = 0.1; });
    changed([&](ModelSource& m) {
      m.features[f].placement.x_axis = std::array<Scalar, 3>{1.0, 0.02, 0.0};
    });
    changed([&](ModelSource& m) {
      m.features[f].placement.z_axis = std::array<Scalar, 3>{0.02, 0.0, 1.0};
    });
  }
  changed([](ModelSource& m) { (*(*m.features[5].profile)[2].through)[1] = 4.1; });
  return all;
}

/// From the nearest of the surfaces that the feature's faces lie on.
double distance_to_surfaces(const Solid& solid, const Vec3& p) {
  double nearest = HUGE_VAL;
  for (const SolidFace& face : solid.faces())
    nearest = std::min(nearest, std::fabs(signed_distance(face.surface, p)));
  return nearest;
}

TEST(MotionBound, NoPointThatASurfacePassesIsFurtherFromIt) {
  Random random(3);
  const FeatureModel before = evaluate(original());
  int still = 0;
  for (const ModelSource& source : changes()) {
    const FeatureModel after = evaluate(source);
    const double motion = bound(original(), source);
    int passed = 0;
    for (std::size_t f = 0; f < before.features.size(); ++f) {
      if (after.features[f].shape == before.features[f].shape &&
          after.features[f].placement.m == before.features[f].placement.m)
        continue;
      const Solid then(before.features[f]), now(after.features[f]);
      Box box = then.bounds();
      box.add(now.bounds());
      for (int k = 0; k < 5000; ++k) {
        const double x = random.uniform(box.lo.x, box.hi.x), y = random.uniform(box.lo.y, box.hi.y);
        const Vec3 p{x, y, random.uniform(box.lo.z, box.hi.z)};
        if (then.contains(p) == now.contains(p)) continue;
        ++passed;
        ASSERT_LE(distance_to_surfaces(then, p), motion) << before.features[f].id;
        ASSERT_LE(distance_to_surfaces(now, p), motion) << before.features[f].id;
      }
    }
    still += passed == 0;
  }
  EXPECT_EQ(still, 5);  // pin, tip, ball and tyre turned about their axes, the ball tilted
}

TEST(MotionBound, OfALengthIsItsChange) {
  const ModelSource model = original();
  for (std::size_t f = 0; f < model.features.size(); ++f)
    for (const auto& [name, value] : model.features[f].parameters) {
      ModelSource changed = model;
      changed.features[f].parameters[name] = std::get<double>(value) + 0.25;
      // The corner of the arch's box, 9 x 9 in plan, stands for what a turn moves most.
      const double most = name == "angle" ? std::hypot(9, 9) * 0.25 * std::acos(-1) / 180 : 0.25;
      EXPECT_LE(bound(model, changed), most + 1e-12) << model.features[f].id << name;
      EXPECT_GT(bound(model, changed), 0.5 * most) << model.features[f].id << name;
    }
}

TEST(MotionBound, OfAShiftIsItsLength) {
  ModelSource changed = original();
  changed.features[4].placement.origin = {3.0, 0.0, -4.0};
  EXPECT_DOUBLE_EQ(bound(original(), changed), 5);
}

TEST(MotionBound, IsThatOfTheFeatureThatMovesMost) {
  ModelSource changed = original();
  changed.features[1].placement.origin = {1.0, 0.0, 0.0};
  changed.features[3].placement.origin = {2.0, 0.0, 0.0};
  changed.features[6].placement.origin = {0.0, 0.5, 0.0};
  EXPECT_DOUBLE_EQ(bound(original(), changed), 2);
  EXPECT_EQ(bound(changed, changed), 0);
}

TEST(MotionBound, IsInfiniteWhereFacesComeOrGo) {
  ModelSource changed = original();
  changed.features[2].parameters["radius_top"] = 0.0;  // the tip's top
  EXPECT_EQ(bound(original(), changed), HUGE_VAL);
  changed = original();
  changed.features[2].parameters["radius_bottom"] = 0.0;
  EXPECT_EQ(bound(original(), changed), HUGE_VAL);
  changed = original();
  (*changed.features[5].profile)[2].through.reset();  // an arc becomes a line
  EXPECT_EQ(bound(original(), changed), HUGE_VAL);
  changed = original();
  (*changed.features[5].profile)[2] = arc(9.0, 9.0, 8.0, 4.0);  // it bulges inward
  EXPECT_EQ(bound(original(), changed), HUGE_VAL);
}

TEST(MotionBound, IsInfiniteBetweenOtherFeatures) {
  const auto infinite = [](const auto& change) {
    ModelSource changed = original();
    change(changed.features);
    EXPECT_EQ(bound(original(), changed), HUGE_VAL);
  };
  infinite([](auto& features) { features[1].id = "peg"; });
  infinite([](auto& features) { features[1].nature = Nature::Subtractive; });
  infinite([](auto& features) { std::swap(features[1], features[2]); });
  infinite([](auto& features) { features.pop_back(); });
  infinite([](auto& features) { features[1] = test::feature("pin", "sphere", {{"radius", 4.0}}); });
  infinite([](auto& features) { features[5].profile->erase(features[5].profile->begin() + 1); });
}

TEST(SameGeometry, EveryParameterOfEveryTypeCounts) {
  ModelSource changed = original();
  for (FeatureSource& feature : changed.features) {
    for (auto& [name, value] : feature.parameters) {
      const double before = std::get<double>(value);
      value = before + 1e-13;
      EXPECT_TRUE(same(original(), changed)) << feature.id << " " << name;
      value = before + 1e-7;
      EXPECT_FALSE(same(original(), changed)) << feature.id << " " << name;
      value = before;
    }
  }
}

TEST(SameGeometry, EveryPointOfAProfileCounts) {
  for (const std::size_t f : {5U, 6U}) {
    for (std::size_t k = 0; k < original().features[f].profile->size(); ++k) {
      ModelSource changed = original();
      Scalar& x = (*changed.features[f].profile)[k].x;
      x = std::get<double>(x) + 1e-9;
      EXPECT_FALSE(same(original(), changed)) << f << " " << k;
    }
  }
  ModelSource changed = original();
  (*(*changed.features[5].profile)[2].through)[0] = 10.0 + 1e-9;
  EXPECT_FALSE(same(original(), changed));
}

TEST(SameGeometry, PlacementCounts) {
  ModelSource changed = original();
  changed.features[7].placement.origin[2] = 1e-13;
  EXPECT_TRUE(same(original(), changed));
  changed.features[7].placement.origin[2] = 1e-9;
  EXPECT_FALSE(same(original(), changed));
  changed = original();
  changed.features[7].placement.x_axis = std::array<Scalar, 3>{1.0, 1e-9, 0.0};
  EXPECT_FALSE(same(original(), changed));
}

TEST(SameGeometry, WordingDoesNotCount) {
  ModelSource changed = original();
  changed.name = "other";
  changed.parameters = {{"r", 4.0}};
  changed.features[1].parameters["radius"] = "r";
  changed.features[1].placement.z_axis = std::array<Scalar, 3>{0.0, 0.0, 5.0};
  changed.features[3].reference = std::array<Scalar, 3>{1.0, 2.0, 3.0};
  EXPECT_TRUE(same(original(), changed));
}

TEST(SameGeometry, IdsNaturesOrderTypesAndNumberCount) {
  ModelSource changed = original();
  changed.features[1].id = "peg";
  EXPECT_FALSE(same(original(), changed));
  changed = original();
  changed.features[1].nature = Nature::Subtractive;
  EXPECT_FALSE(same(original(), changed));
  changed = original();
  std::swap(changed.features[1], changed.features[2]);
  EXPECT_FALSE(same(original(), changed));
  changed = original();
  changed.features.pop_back();
  EXPECT_FALSE(same(original(), changed));
  changed = original();
  changed.features[1] = test::feature("pin", "sphere", {{"radius", 4.0}});
  EXPECT_FALSE(same(original(), changed));
  changed = original();
  changed.features[5].profile->erase(changed.features[5].profile->begin() + 1);
  EXPECT_FALSE(same(original(), changed));
}

TEST(SameGeometry, ToleranceFollowsTheSizeOfTheModel) {
  ModelSource a =
      test::one_feature(test::feature("base", "block", {{"dx", 1e6}, {"dy", 1e6}, {"dz", 1e6}}));
  ModelSource b = a;
  b.features[0].parameters["dz"] = 1e6 + 1e-7;  // 6e-14 of the diagonal
  EXPECT_TRUE(same(a, b));
  b.features[0].parameters["dz"] = 1e6 + 1e-5;  // 6e-12
  EXPECT_FALSE(same(a, b));
}

}  // namespace
}  // namespace remeshd
