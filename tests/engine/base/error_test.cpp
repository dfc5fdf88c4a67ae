#include "engine/base/error.h"

#include <gtest/gtest.h>

namespace remeshd {
namespace {

TEST(Error, OfAFeaturesParameterNamesBothInItsMessage) {
  const ErrorInfo frame = error::degenerate_frame("rib", "zAxis", "is zero").info();
  EXPECT_EQ(frame.message, "zAxis of feature 'rib' is zero");
  EXPECT_EQ(frame.features, FeatureIds{"rib"});
  EXPECT_EQ(frame.parameter, "zAxis");
  const ErrorInfo size = error::degenerate_feature("pin", "radius", -2, "is negative").info();
  EXPECT_EQ(size.message, "radius of feature 'pin' is -2: it is negative");
  EXPECT_EQ(size.features, FeatureIds{"pin"});
  EXPECT_EQ(size.parameter, "radius");
}

}  // namespace
}  // namespace remeshd
