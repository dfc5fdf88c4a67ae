#include "engine/model/profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/random.h"
#include "engine/model/expression.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"

namespace remeshd {
namespace {

using test::arc;
using test::point;
using Entries = std::vector<ProfileEntry>;

using std::numbers::pi;

std::vector<ProfileSide> outline(const Entries& entries) {
  return evaluate_profile(entries, Scope({{"a", 4.0}}), "web");
}
std::string outline_failure(const Entries& entries) {
  return test::place_of(test::error_of([&] { outline(entries); }));
}
Entries mirrored(const Entries& entries) {  // turns the other way
  Entries result;
  for (const ProfileEntry& e : entries) {
    result.push_back(point(e.x, -std::get<double>(e.y)));
    if (e.through)
      result.back().through =
          std::array<Scalar, 2>{(*e.through)[0], -std::get<double>((*e.through)[1])};
  }
  return result;
}

TEST(Profile, SidesRunFromEntryToEntryAndTheLastOneCloses) {
  const auto sides = outline({point(0.0, 0.0), point("a", 0.0), point(0.0, "a-1")});
  ASSERT_EQ(sides.size(), 3U);
  EXPECT_EQ(sides[0].from, (Point2{0, 0}));
  EXPECT_EQ(sides[0].to, (Point2{4, 0}));
  EXPECT_EQ(sides[2].from, (Point2{0, 3}));
  EXPECT_EQ(sides[2].to, (Point2{0, 0}));
  EXPECT_DOUBLE_EQ(signed_area(sides), 6);
}

TEST(Profile, ALastEntryThatReturnsToTheFirstClosesTheLoopItself) {
  const auto sides =
      outline({point(0.0, 0.0), point(4.0, 0.0), point(0.0, 3.0), point(1e-12, -1e-12)});
  ASSERT_EQ(sides.size(), 3U);
  EXPECT_EQ(sides[2].to, (Point2{0, 0}));
}

TEST(Profile, AnArcBelongsToTheSideThatItEnds) {
  const auto sides = outline({point(-1.0, 0.0), point(1.0, 0.0), arc(-1.0, 0.0, 0.0, 1.0)});
  ASSERT_EQ(sides.size(), 2U);
  EXPECT_FALSE(sides[0].arc);
  ASSERT_TRUE(sides[1].arc);
  EXPECT_TRUE(sides[1].counter_clockwise);
  EXPECT_NEAR(sides[1].centre[0], 0, 1e-16);
  EXPECT_NEAR(sides[1].centre[1], 0, 1e-16);
  EXPECT_DOUBLE_EQ(sides[1].radius, 1);
  EXPECT_DOUBLE_EQ(sweep(sides[1]), pi);
  EXPECT_DOUBLE_EQ(signed_area(sides), pi / 2);
}

TEST(Profile, MayTurnEitherWay) {
  const Entries key{point(0.0, 0.0), point(4.0, 0.0), arc(4.0, 2.0, 5.0, 1.0), point(0.0, 2.0)};
  EXPECT_DOUBLE_EQ(signed_area(outline(key)), 8 + pi / 2);
  EXPECT_DOUBLE_EQ(signed_area(outline(mirrored(key))), -8 - pi / 2);
}

TEST(Profile, ArcsMayBulgeInwardsAndTurnThroughMoreThanHalfACircle) {
  const Entries notch{point(0.0, 0.0), point(4.0, 0.0), arc(4.0, 2.0, 3.5, 1.0), point(0.0, 2.0)};
  const double r = 1.25, half = std::asin(0.8);  // chord 2, sagitta 0.5
  EXPECT_DOUBLE_EQ(signed_area(outline(notch)), 8 - r * r * (half - 0.8 * 0.6));
  const auto keyhole = outline({point(-0.6, -0.8), arc(0.6, -0.8, 0.0, 1.0)});
  ASSERT_EQ(keyhole.size(), 2U);
  EXPECT_FALSE(keyhole[0].counter_clockwise);
  EXPECT_GT(std::fabs(sweep(keyhole[0])), pi);
  const double t = std::fabs(sweep(keyhole[0]));
  EXPECT_NEAR(std::fabs(signed_area(keyhole)), 0.5 * (t - std::sin(t)), 1e-14);
}

TEST(Profile, TwoArcsMayMakeACircleOrALens) {
  const auto circle =
      outline({point(-2.0, 0.0), arc(2.0, 0.0, 0.0, -2.0), arc(-2.0, 0.0, 0.0, 2.0)});
  ASSERT_EQ(circle.size(), 2U);
  EXPECT_DOUBLE_EQ(signed_area(circle), 4 * pi);
  const auto lens = outline({point(-1.0, 0.0), arc(1.0, 0.0, 0.0, -0.5), arc(-1.0, 0.0, 0.0, 0.5)});
  EXPECT_EQ(lens.size(), 2U);
}

TEST(Profile, AreaAndMomentAgreeWithAFinePolygon) {
  const auto sides = outline({point(3.0, 0.0), point(7.0, 1.0), arc(6.0, 4.0, 8.0, 3.0),
                              arc(4.0, 5.0, 5.5, 4.2), arc(2.0, 3.0, 2.0, 4.5)});
  double area = 0, moment = 0;
  for (const ProfileSide& s : sides) {
    constexpr int kSteps = 20000;
    for (int k = 0; k < kSteps; ++k) {
      const auto at = [&](int i) -> Point2 {
        const double t = static_cast<double>(i) / kSteps;
        if (!s.arc)
          return {s.from[0] + t * (s.to[0] - s.from[0]), s.from[1] + t * (s.to[1] - s.from[1])};
        const double start = std::atan2(s.from[1] - s.centre[1], s.from[0] - s.centre[0]);
        return {s.centre[0] + s.radius * std::cos(start + t * sweep(s)),
                s.centre[1] + s.radius * std::sin(start + t * sweep(s))};
      };
      const Point2 p = at(k), q = at(k + 1);
      const double piece = 0.5 * (p[0] * q[1] - q[0] * p[1]);
      area += piece;
      moment += piece * (p[0] + q[0]) / 3;
    }
  }
  EXPECT_NEAR(signed_area(sides), area, 1e-6);
  EXPECT_NEAR(moment_about_axis(sides), moment, 1e-6);
}

TEST(Profile, NearlyStraightArcsKeepTheirDigits) {
  const auto sides = outline({point(0.0, 0.0), arc(1.0, 0.0, 0.5, -1e-5), point(0.5, 1.0)});
  EXPECT_NEAR(signed_area(sides), 0.5 + 2.0 / 3 * 1e-5, 1e-13);
  EXPECT_NEAR(moment_about_axis(sides), 0.5 * (0.5 + 2.0 / 3 * 1e-5), 1e-13);
}

TEST(Profile, BoundsOfArcsReachTheirExtremes) {
  const Box2 box = profile_bounds(
      outline({point(0.0, 0.0), point(4.0, 0.0), arc(4.0, 2.0, 5.0, 1.0), point(0.0, 2.0)}));
  EXPECT_EQ(box.lo, (Point2{0, 0}));
  EXPECT_EQ(box.hi, (Point2{5, 2}));
}

TEST(Profile, NeedsThreeSidesOrTwoWithAnArc) {
  EXPECT_EQ(outline_failure({}), "INVALID_PROFILE web profile");
  EXPECT_EQ(outline_failure({point(0.0, 0.0)}), "INVALID_PROFILE web profile");
  EXPECT_EQ(outline_failure({point(0.0, 0.0), point(1.0, 0.0)}), "INVALID_PROFILE web profile");
  EXPECT_EQ(outline_failure({point(0.0, 0.0), point(1.0, 0.0), point(0.0, 0.0)}),
            "INVALID_PROFILE web profile");
  EXPECT_EQ(outline({point(0.0, 0.0), arc(1.0, 0.0, 0.5, 0.5)}).size(), 2U);
}

TEST(Profile, StartsWithAPoint) {
  EXPECT_EQ(outline_failure({arc(0.0, 0.0, 1.0, 1.0), point(2.0, 0.0), point(1.0, 3.0)}),
            "INVALID_PROFILE web profile[0]");
}

TEST(Profile, SidesHaveALength) {
  EXPECT_EQ(outline_failure({point(0.0, 0.0), point(1.0, 0.0), point(1.0, 0.0), point(0.0, 1.0)}),
            "INVALID_PROFILE web profile[2]");
  EXPECT_EQ(
      outline_failure({point(0.0, 0.0), point(1.0, 0.0), point(0.0, 1.0), point(0.0, 1.0 + 1e-11)}),
      "INVALID_PROFILE web profile[3]");
  EXPECT_EQ(outline_failure({point(5.0, 5.0), point(5.0, 5.0), point(5.0, 5.0)}),
            "INVALID_PROFILE web profile[1]");
  EXPECT_EQ(outline_failure({point(0.0, 0.0), arc(0.0, 0.0, 1.0, 1.0)}),
            "INVALID_PROFILE web profile[1]");
  EXPECT_EQ(
      outline_failure({point(0.0, 0.0), point(1.0, 0.0), point(0.0, 1.0), arc(0.0, 1.0, 3.0, 3.0)}),
      "INVALID_PROFILE web profile[3]");
}

TEST(Profile, PointsOfAnArcDoNotLieOnALine) {
  const auto bent = [](double tx, double ty) {
    return Entries{point(0.0, 0.0), point(2.0, 0.0), arc(2.0, 2.0, tx, ty), point(0.0, 2.0)};
  };
  EXPECT_EQ(outline_failure(bent(2, 1)), "INVALID_PROFILE web profile[2].through");
  EXPECT_EQ(outline_failure(bent(2, 7)), "INVALID_PROFILE web profile[2].through");
  EXPECT_EQ(outline_failure(bent(2, 2)), "INVALID_PROFILE web profile[2].through");
  EXPECT_EQ(outline_failure(bent(2, 0)), "INVALID_PROFILE web profile[2].through");
  EXPECT_EQ(outline_failure(bent(2 + 1e-8, 1)), "INVALID_PROFILE web profile[2].through");
  EXPECT_NO_THROW(outline(bent(2 + 1e-4, 1)));
}

TEST(Profile, ErrorsOfNumbersNameTheEntry) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(outline_failure({point(0.0, 0.0), point(nan, 0.0), point(0.0, 1.0)}),
            "NON_FINITE_VALUE web profile[1]");
  EXPECT_EQ(outline_failure({point(0.0, 0.0), point(1.0, 0.0), point(0.0, "b")}),
            "UNKNOWN_NAME web profile[2]");
  EXPECT_EQ(outline_failure({point(0.0, 0.0), point(1.0, 0.0), arc(0.0, 1.0, "a=1", 3.0)}),
            "INVALID_EXPRESSION web profile[2].through");
  EXPECT_EQ(outline_failure({point(0.0, 0.0), point(2e9, 0.0), point(0.0, 1.0)}),
            "VALUE_OUT_OF_RANGE web profile[1]");
}

TEST(Profile, NumberOfEntriesIsLimited) {
  Entries round;
  for (int k = 0; k < 1001; ++k)
    round.push_back(point(std::cos(2 * pi * k / 1001), std::sin(2 * pi * k / 1001)));
  EXPECT_EQ(outline_failure(round), "LIMIT_EXCEEDED web profile");
  round.pop_back();
  EXPECT_EQ(outline(round).size(), 1000U);
}

TEST(SimpleProfile, CrossingSegmentsAreRefused) {
  EXPECT_EQ(outline_failure({point(0.0, 0.0), point(2.0, 2.0), point(2.0, 0.0), point(0.0, 2.0)}),
            "SELF_INTERSECTING_PROFILE web profile[2]");
}

TEST(SimpleProfile, TouchingIsRefused) {
  // A corner on a side.
  EXPECT_EQ(outline_failure({point(0.0, 0.0), point(4.0, 0.0), point(4.0, 4.0), point(2.0, 0.0),
                             point(0.0, 4.0)}),
            "SELF_INTERSECTING_PROFILE web profile[2]");
  // A corner on a corner.
  EXPECT_EQ(outline_failure({point(0.0, 0.0), point(2.0, 1.0), point(4.0, 0.0), point(4.0, 4.0),
                             point(2.0, 1.0), point(0.0, 4.0)}),
            "SELF_INTERSECTING_PROFILE web profile[3]");
  // Nearer than rounding can tell apart.
  EXPECT_EQ(outline_failure({point(0.0, 0.0), point(4.0, 0.0), point(4.0, 4.0), point(2.0, 1e-10),
                             point(0.0, 4.0)}),
            "SELF_INTERSECTING_PROFILE web profile[2]");
  EXPECT_NO_THROW(outline(
      {point(0.0, 0.0), point(4.0, 0.0), point(4.0, 4.0), point(2.0, 1e-6), point(0.0, 4.0)}));
}

TEST(SimpleProfile, OverlapsAndSpikesAreRefused) {
  EXPECT_EQ(outline_failure({point(0.0, 0.0), point(4.0, 0.0), point(2.0, 0.0), point(2.0, 3.0)}),
            "SELF_INTERSECTING_PROFILE web profile[1]");
  EXPECT_EQ(outline_failure({point(0.0, 0.0), point(1.0, 0.0), point(2.0, 0.0)}),
            "SELF_INTERSECTING_PROFILE web profile[2]");
  EXPECT_EQ(outline_failure({point(0.0, 0.0), point(4.0, 0.0), point(4.0, 4.0), point(4.0, 8.0),
                             point(4.0, 4.0), point(0.0, 4.0)}),
            "SELF_INTERSECTING_PROFILE web profile[3]");
}

TEST(SimpleProfile, CornersInTheMiddleOfAStraightLineAreAllowed) {
  EXPECT_EQ(outline({point(0.0, 0.0), point(1.0, 0.0), point(2.0, 0.0), point(2.0, 2.0)}).size(),
            4U);
}

TEST(SimpleProfile, ArcsThatReachAnotherSideAreRefused) {
  const auto box = [](double depth) {  // the right side bulges to the left by `depth`
    return Entries{point(0.0, 0.0), point(4.0, 0.0), arc(4.0, 4.0, 4.0 - depth, 2.0),
                   point(0.0, 4.0)};
  };
  EXPECT_NO_THROW(outline(box(1.0)));
  EXPECT_NO_THROW(outline(box(1.9)));
  EXPECT_EQ(outline_failure(box(2.1)), "SELF_INTERSECTING_PROFILE web profile[1]");  // beyond y = 0
  EXPECT_EQ(outline_failure(box(4.5)), "SELF_INTERSECTING_PROFILE web profile[1]");
  // Touches the left side without crossing it.
  EXPECT_EQ(
      outline_failure({point(3.0, 0.0), point(4.0, 0.0), arc(4.0, 4.0, 3.0, 2.0), point(3.0, 4.0)}),
      "SELF_INTERSECTING_PROFILE web profile[3]");
}

TEST(SimpleProfile, AnArcThatMeetsItsNeighbourAgainIsRefused) {
  // The arc starts at (4, 0) below the line y = 0 and comes up through it at x = 2.
  EXPECT_EQ(outline_failure({point(0.0, 0.0), point(4.0, 0.0), arc(2.0, 1.0, 3.0, -1.0)}),
            "SELF_INTERSECTING_PROFILE web profile[1]");
}

TEST(SimpleProfile, CrossingAndTouchingArcsAreRefused) {
  const auto waist = [](double depth) {  // top and bottom bulge inwards
    return Entries{point(0.0, 0.0), arc(4.0, 0.0, 2.0, depth), point(4.0, 2.0),
                   arc(0.0, 2.0, 2.0, 2.0 - depth)};
  };
  EXPECT_NO_THROW(outline(waist(0.999)));
  EXPECT_EQ(outline_failure(waist(1.0)), "SELF_INTERSECTING_PROFILE web profile[2]");
  EXPECT_EQ(outline_failure(waist(1.1)), "SELF_INTERSECTING_PROFILE web profile[2]");
}

TEST(SimpleProfile, ArcsOfOneCircleThatOverlapAreRefused) {
  // 0 to 200 degrees, then on to 400 degrees.
  const auto at = [](double degrees) {
    return Point2{std::cos(degrees * pi / 180), std::sin(degrees * pi / 180)};
  };
  const Point2 a = at(0), b = at(100), c = at(200), d = at(300), e = at(400);
  EXPECT_EQ(outline_failure({point(a[0], a[1]), arc(c[0], c[1], b[0], b[1]),
                             arc(e[0], e[1], d[0], d[1]), point(2.0, 0.5)})
                .substr(0, 25),
            "SELF_INTERSECTING_PROFILE");
}

TEST(SimpleProfile, CuspsAreRefusedAndSmoothJointsAllowed) {
  const double s = std::sqrt(0.5);
  // Rounded rectangle: every arc is tangent to both neighbours.
  const Entries rounded{point(1.0, 0.0),
                        point(4.0, 0.0),
                        arc(5.0, 1.0, 4 + s, 1 - s),
                        point(5.0, 3.0),
                        arc(4.0, 4.0, 4 + s, 3 + s),
                        point(1.0, 4.0),
                        arc(0.0, 3.0, 1 - s, 3 + s),
                        point(0.0, 1.0),
                        arc(1.0, 0.0, 1 - s, 1 - s)};
  const auto sides = outline(rounded);
  EXPECT_EQ(sides.size(), 8U);
  EXPECT_NEAR(signed_area(sides), 20 - 4 + pi, 1e-14);
  EXPECT_EQ(outline(mirrored(rounded)).size(), 8U);
  // The same with coordinates cut to six digits.
  EXPECT_EQ(
      outline({point(1.0, 0.0), point(4.0, 0.0), arc(5.0, 1.0, 4.707107, 0.292893), point(5.0, 4.0),
               point(0.0, 4.0), point(0.0, 1.0), arc(1.0, 0.0, 0.292893, 0.292893)})
          .size(),
      6U);
  // A half disc out of which two half discs are cut, all tangent at their ends.
  EXPECT_EQ(outline_failure({point(0.0, 0.0), arc(4.0, 0.0, 2.0, -2.0), arc(2.0, 0.0, 3.0, -1.0),
                             arc(0.0, 0.0, 1.0, -1.0)}),
            "SELF_INTERSECTING_PROFILE web profile[1]");
  // A crescent whose horns are cusps.
  EXPECT_EQ(outline_failure({point(0.0, 0.0), arc(0.0, 4.0, 2.0, 2.0), arc(0.0, 2.0, 1.0, 3.0),
                             arc(0.0, 0.0, -1.0, 1.0)})
                .substr(0, 25),
            "SELF_INTERSECTING_PROFILE");
}

/// The outline as a closed polyline, arcs in `steps` pieces, by formulas of its own.
std::vector<Point2> polyline(const Entries& entries, int steps) {
  std::vector<Point2> loop;
  const auto number = [](const Scalar& v) { return std::get<double>(v); };
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const ProfileEntry& end = entries[(k + 1) % entries.size()];
    const double ax = number(entries[k].x), ay = number(entries[k].y);
    loop.push_back({ax, ay});
    if (!end.through) continue;
    const double bx = number((*end.through)[0]), by = number((*end.through)[1]);
    const double cx = number(end.x), cy = number(end.y);
    const double d = 2 * (ax * (by - cy) + bx * (cy - ay) + cx * (ay - by));
    const double a2 = ax * ax + ay * ay, b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
    const double mx = (a2 * (by - cy) + b2 * (cy - ay) + c2 * (ay - by)) / d;
    const double my = (a2 * (cx - bx) + b2 * (ax - cx) + c2 * (bx - ax)) / d;
    const double start = std::atan2(ay - my, ax - mx);
    double middle = std::atan2(by - my, bx - mx) - start,
           turn = std::atan2(cy - my, cx - mx) - start;
    while (middle < 0) middle += 2 * pi;
    while (turn < 0) turn += 2 * pi;
    if (middle > turn) turn -= 2 * pi;
    for (int i = 1; i < steps; ++i) {
      const double t = start + turn * i / steps, r = std::hypot(ax - mx, ay - my);
      loop.push_back({mx + r * std::cos(t), my + r * std::sin(t)});
    }
  }
  return loop;
}

bool crosses_itself(const std::vector<Point2>& loop) {
  const auto turn = [](const Point2& a, const Point2& b, const Point2& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  };
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      const Point2 &a = loop[i], &b = loop[i + 1], &c = loop[j], &d = loop[(j + 1) % n];
      if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) return true;
    }
  }
  return false;
}

TEST(SimpleProfile, AgreesWithAFinePolygonOnRandomOutlines) {
  Random random(5);
  int simple = 0, crossing = 0, undecided = 0;
  for (int k = 0; k < 2000; ++k) {
    Entries entries;
    const auto n = 3 + random.below(4);
    for (std::uint64_t i = 0; i < n; ++i) {
      const double x = random.uniform(0, 10), y = random.uniform(0, 10);
      entries.push_back(point(x, y));
      if (i > 0 && random.uniform() < 0.5)
        entries.back() = arc(x, y, random.uniform(0, 10), random.uniform(0, 10));
    }
    const bool expected = crosses_itself(polyline(entries, 200));
    try {
      outline(entries);
      EXPECT_FALSE(expected) << "outline " << k;
      ++simple;
    } catch (const Error& e) {
      EXPECT_EQ(e.info().reason, "SELF_INTERSECTING_PROFILE") << e.what();
      ++(expected ? crossing
                  : undecided);  // arcs may graze each other between the polygon's corners
    }
  }
  EXPECT_GT(simple, 200);
  EXPECT_GT(crossing, 200);
  EXPECT_LE(undecided, 2);
}

}  // namespace
}  // namespace remeshd
