#include "engine/base/vec.h"

#include <gtest/gtest.h>

namespace remeshd {
namespace {

TEST(LiesBefore, GoesByXThenByYThenByZ) {
  EXPECT_TRUE(lies_before({0, 1, 1}, {1, 0, 0}));
  EXPECT_FALSE(lies_before({1, 0, 0}, {0, 1, 1}));
  EXPECT_TRUE(lies_before({0, 0, 1}, {0, 1, 0}));
  EXPECT_FALSE(lies_before({0, 1, 0}, {0, 0, 1}));
  EXPECT_TRUE(lies_before({0, 0, 0}, {0, 0, 1}));
  EXPECT_FALSE(lies_before({0, 0, 0}, {0, 0, 0}));
}

TEST(Boxes, TouchWhereTheyHaveAPointInCommon) {
  const Box box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_TRUE(touch(box, {{1, 1, 1}, {2, 2, 2}}));
  EXPECT_TRUE(touch(box, {{0.2, 0.2, 0.2}, {0.3, 0.3, 0.3}}));
  for (const Vec3& by : {Vec3{1.5, 0, 0}, Vec3{0, 1.5, 0}, Vec3{0, 0, 1.5}}) {
    EXPECT_FALSE(touch(box, {box.lo + by, box.hi + by}));
    EXPECT_FALSE(touch(box, {box.lo - by, box.hi - by}));
  }
}

}  // namespace
}  // namespace remeshd
