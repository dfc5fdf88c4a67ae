#include "engine/model/placement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/base/random.h"
#include "engine/model/expression.h"
#include "tests/support/expect_error.h"

namespace remeshd {
namespace {

using Triple = std::array<Scalar, 3>;

Transform placed(const PlacementSource& source) {
  return evaluate_placement(source, Scope({{"a", 30.0}}), "rib");
}
std::string placement_failure(const PlacementSource& source) {
  return test::place_of(test::error_of([&] { placed(source); }));
}
Vec3 column(const Transform& t, int k) { return {t.m[k], t.m[4 + k], t.m[8 + k]}; }

TEST(Placement, DefaultsToTheIdentity) { EXPECT_TRUE(placed({}).is_identity()); }

TEST(Placement, OriginMayBeExpressions) {
  EXPECT_EQ(placed({Triple{"a+1", 2.0, "-a"}, {}, {}}), Transform::translation({31, 2, -30}));
}

TEST(Placement, AxesAlongTheWorldsAreExact) {
  const Transform t =
      placed({Triple{0.0, 5.0, 0.0}, Triple{0.0, -1.0, 0.0}, Triple{1.0, 0.0, 0.0}});
  EXPECT_EQ(column(t, 0), (Vec3{1, 0, 0}));
  EXPECT_EQ(column(t, 1), (Vec3{0, 0, 1}));
  EXPECT_EQ(column(t, 2), (Vec3{0, -1, 0}));
  EXPECT_EQ(column(t, 3), (Vec3{0, 5, 0}));
}

TEST(Placement, LengthOfAnAxisDoesNotMatter) {
  for (const double s : {1e-8, 0.3, 7.0, 1e8}) {
    const Transform t = placed({Triple{0.0, 0.0, 0.0}, Triple{0.0, 0.0, -s}, Triple{0.0, s, 0.0}});
    EXPECT_EQ(column(t, 0), (Vec3{0, 1, 0})) << s;
    EXPECT_EQ(column(t, 1), (Vec3{1, 0, 0})) << s;
    EXPECT_EQ(column(t, 2), (Vec3{0, 0, -1})) << s;
  }
}

TEST(Placement, DefaultXAxisTurnsToYWhereZLiesAlongIt) {
  for (const double sign : {1.0, -1.0}) {
    const Transform t = placed({Triple{0.0, 0.0, 0.0}, Triple{sign, 0.0, 0.0}, {}});
    EXPECT_EQ(column(t, 0), (Vec3{0, 1, 0}));
    EXPECT_EQ(column(t, 2), (Vec3{sign, 0, 0}));
    EXPECT_EQ(column(t, 1), (Vec3{0, 0, sign}));
  }
}

TEST(Placement, XAxisIsMadePerpendicularInThePlaneItWasGivenIn) {
  const Transform t = placed({Triple{0.0, 0.0, 0.0}, Triple{0.0, 0.0, 2.0}, Triple{1.0, 1.0, 9.0}});
  EXPECT_NEAR(distance(column(t, 0), {std::sqrt(0.5), std::sqrt(0.5), 0}), 0, 1e-15);
  EXPECT_EQ(column(t, 2), (Vec3{0, 0, 1}));
}

TEST(Placement, FramesAreRightHandedAndOrthonormalEvenFromNearlyParallelAxes) {
  Random random(7);
  for (int k = 0; k < 500; ++k) {
    const double z[3] = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const double nearly = k % 2 == 0 ? 1.0 : 1e-7;
    const Triple z_axis{z[0], z[1], z[2]};
    const Triple x_axis{z[0] + nearly * random.uniform(-1, 1),
                        z[1] + nearly * random.uniform(-1, 1),
                        z[2] + nearly * random.uniform(-1, 1)};
    const Transform t = placed({Triple{0.0, 0.0, 0.0}, z_axis, x_axis});
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(norm(column(t, i)), 1, 1e-15);
      EXPECT_NEAR(dot(column(t, i), column(t, (i + 1) % 3)), 0, 3e-16);
      EXPECT_NEAR(distance(cross(column(t, i), column(t, (i + 1) % 3)), column(t, (i + 2) % 3)), 0,
                  1e-15);
    }
  }
}

TEST(Placement, DegenerateFramesAreRefused) {
  const Triple origin{0.0, 0.0, 0.0};
  EXPECT_EQ(placement_failure({origin, Triple{0.0, 0.0, 0.0}, {}}),
            "DEGENERATE_FRAME rib placement.zAxis");
  EXPECT_EQ(placement_failure({origin, Triple{0.0, 0.0, 1e-12}, {}}),
            "DEGENERATE_FRAME rib placement.zAxis");
  EXPECT_EQ(placement_failure({origin, {}, Triple{0.0, 0.0, 0.0}}),
            "DEGENERATE_FRAME rib placement.xAxis");
  EXPECT_EQ(placement_failure({origin, {}, Triple{0.0, 0.0, 3.0}}),
            "DEGENERATE_FRAME rib placement.xAxis");
  EXPECT_EQ(placement_failure({origin, Triple{1.0, 2.0, 3.0}, Triple{-2.0, -4.0, -6.0}}),
            "DEGENERATE_FRAME rib placement.xAxis");
  EXPECT_EQ(placement_failure({origin, Triple{1.0, 0.0, 0.0}, Triple{1.0, 0.0, 0.0}}),
            "DEGENERATE_FRAME rib placement.xAxis");
}

TEST(Placement, ErrorsNameTheComponent) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(placement_failure({Triple{0.0, nan, 0.0}, {}, {}}),
            "NON_FINITE_VALUE rib placement.origin[1]");
  EXPECT_EQ(placement_failure({Triple{0.0, 0.0, "b"}, {}, {}}),
            "UNKNOWN_NAME rib placement.origin[2]");
  EXPECT_EQ(placement_failure({Triple{-2e9, 0.0, 0.0}, {}, {}}),
            "VALUE_OUT_OF_RANGE rib placement.origin[0]");
  EXPECT_EQ(placement_failure({{0.0, 0.0, 0.0}, Triple{"1/0", 0.0, 0.0}, {}}),
            "NON_FINITE_VALUE rib placement.zAxis[0]");
  EXPECT_EQ(placement_failure({{0.0, 0.0, 0.0}, {}, Triple{1.0, "1,2", 0.0}}),
            "INVALID_EXPRESSION rib placement.xAxis[1]");
}

}  // namespace
}  // namespace remeshd
