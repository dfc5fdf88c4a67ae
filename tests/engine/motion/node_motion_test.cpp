#include "engine/motion/node_motion.h"

#include <gtest/gtest.h>

#include <vector>

namespace remeshd {
namespace {

TEST(CommonMotion, OfOneSurfaceIsAlongItsNormal) {
  const CommonMotion c = common_motion(std::vector<SurfaceMotion>{{{0, 0, 1}, 2}});
  EXPECT_TRUE(c.defined);
  EXPECT_EQ(c.motion.required, (Vec3{0, 0, 2}));
  EXPECT_EQ(c.motion.freedom({3, 4, 5}), (Vec3{3, 4, 0}));
}

TEST(CommonMotion, OfTwoSurfacesKeepsToBothAndLeavesTheLineFree) {
  const double h = std::sqrt(0.5);
  const CommonMotion c = common_motion(std::vector<SurfaceMotion>{{{0, 0, 1}, 2}, {{h, 0, h}, 1}});
  EXPECT_TRUE(c.defined);
  EXPECT_NEAR(c.motion.required.z, 2, 1e-14);
  EXPECT_NEAR(dot(c.motion.required, Vec3{h, 0, h}), 1, 1e-14);
  EXPECT_NEAR(distance(c.motion.freedom({3, 4, 5}), Vec3{0, 4, 0}), 0, 1e-14);
}

TEST(CommonMotion, OfThreeSurfacesLeavesNothingFree) {
  const CommonMotion c =
      common_motion(std::vector<SurfaceMotion>{{{1, 0, 0}, 1}, {{0, 1, 0}, 2}, {{0, 0, 1}, 3}});
  EXPECT_TRUE(c.defined);
  EXPECT_EQ(c.motion.required, (Vec3{1, 2, 3}));
  EXPECT_EQ(c.motion.freedom({3, 4, 5}), (Vec3{}));
}

TEST(CommonMotion, OfSurfacesThatPartIsUndefined) {
  EXPECT_FALSE(common_motion(std::vector<SurfaceMotion>{{{0, 0, 1}, 2}, {{0, 0, -1}, 2}}).defined);
  EXPECT_TRUE(common_motion(std::vector<SurfaceMotion>{{{0, 0, 1}, 2}, {{0, 0, -1}, -2}}).defined);
  EXPECT_FALSE(common_motion(std::vector<SurfaceMotion>{
                                 {{1, 0, 0}, 1}, {{0, 1, 0}, 2}, {{0, 0, 1}, 3}, {{0, 0, 1}, 1}})
                   .defined);
}

}  // namespace
}  // namespace remeshd
