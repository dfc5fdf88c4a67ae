#include "engine/cellular/features_at.h"

#include <gtest/gtest.h>

#include "tests/support/cases.h"

namespace remeshd {
namespace {

FeatureIds at(const FeatureModel& model, const Vec3& place) {
  return features_at(model, Membership(model), place);
}

TEST(FeaturesAt, AreThoseThatMeetThere) {
  const FeatureModel model = evaluate(test::model_of(
      {test::block("plate", 100, 100, 10), test::placed(test::cylinder("pin", 5, 20), 0, 0, 10)}));
  const Box pin = Membership(model).solids()[1].bounds();
  const Vec3 foot{pin.hi.x, 0.5 * (pin.lo.y + pin.hi.y), pin.lo.z};
  EXPECT_EQ(at(model, foot), (FeatureIds{"plate", "pin"}));
  EXPECT_EQ(at(model, {pin.hi.x, foot.y, pin.hi.z}), FeatureIds{"pin"});
}

TEST(FeaturesAt, IsTheNearestAloneWhereNoTwoAreNearAtOnce) {
  const FeatureModel model = evaluate(test::model_of(
      {test::block("block", 100, 100, 100),
       test::placed(test::feature("grain", "sphere", {{"radius", 1e-3}}), 0, 0, 99)}));
  // The block's top is a thousand times as far away as the grain is large.
  EXPECT_EQ(at(model, {0, 0, 99 + 1e-3 + 1e-5}), FeatureIds{"grain"});
}

}  // namespace
}  // namespace remeshd
