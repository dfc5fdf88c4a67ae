#include "engine/model/solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "engine/base/random.h"
#include "tests/support/cases.h"

namespace remeshd {
namespace {

using test::arc;
using test::feature;
using test::point;

using std::numbers::pi;

struct Sample {
  FeatureSource source;
  double volume;  ///< by hand
  std::vector<std::string> faces;
};

/// One feature of every type and every special form of it.
std::vector<Sample> samples() {
  const std::vector<ProfileEntry> ell{point(0.0, 0.0), point(4.0, 0.0), point(4.0, 1.0),
                                      point(1.0, 1.0), point(1.0, 3.0), point(0.0, 3.0)};
  const std::vector<ProfileEntry> bean{point(0.0, 0.0), point(4.0, 0.0), arc(4.0, 2.0, 5.0, 1.0),
                                       arc(0.0, 2.0, 2.0, 1.5)};
  const std::vector<ProfileEntry> clockwise{point(0.0, 0.0), arc(0.0, 2.0, -1.0, 1.0),
                                            point(3.0, 2.0), point(3.0, 0.0)};
  const double s = std::sqrt(0.5);
  const std::vector<ProfileEntry> keyhole{point(-s, -s), arc(s, -s, 0.0, 1.0)};
  // Dip of `bean`: chord 4, sagitta 0.5, so radius 4.25.
  const double dip = 4.25 * 4.25 * (std::asin(2 / 4.25) - 2 * 3.75 / (4.25 * 4.25));
  return {
      {feature("block", "block", {{"dx", 4.0}, {"dy", 3.0}, {"dz", 2.0}}),
       24,
       {"x_min", "x_max", "y_min", "y_max", "bottom", "top"}},
      {feature("cylinder", "cylinder", {{"radius", 2.0}, {"height", 3.0}}),
       12 * pi,
       {"wall", "bottom", "top"}},
      {feature("frustum", "cone", {{"radius_bottom", 2.0}, {"radius_top", 1.0}, {"height", 3.0}}),
       7 * pi,
       {"wall", "bottom", "top"}},
      {feature("cone", "cone", {{"radius_bottom", 2.0}, {"radius_top", 0.0}, {"height", 3.0}}),
       4 * pi,
       {"wall", "bottom"}},
      {feature("funnel", "cone", {{"radius_bottom", 0.0}, {"radius_top", 2.0}, {"height", 3.0}}),
       4 * pi,
       {"wall", "top"}},
      {feature("straight_cone", "cone",
               {{"radius_bottom", 2.0}, {"radius_top", 2.0}, {"height", 3.0}}),
       12 * pi,
       {"wall", "bottom", "top"}},
      {feature("sphere", "sphere", {{"radius", 2.0}}), 32 * pi / 3, {"surface"}},
      {feature("torus", "torus", {{"major_radius", 3.0}, {"minor_radius", 1.0}}),
       6 * pi * pi,
       {"surface"}},
      {feature("ell", "prism", ell, {{"height", 2.0}}),
       12,
       {"side1", "side2", "side3", "side4", "side5", "side6", "bottom", "top"}},
      {feature("bean", "prism", bean, {{"height", 2.0}}),
       2 * (8 + pi / 2 - dip),
       {"side1", "side2", "side3", "side4", "bottom", "top"}},
      {feature("clockwise", "prism", clockwise, {{"height", 2.0}}),
       2 * (6 + pi / 2),
       {"side1", "side2", "side3", "side4", "bottom", "top"}},
      {feature("keyhole", "prism", keyhole, {{"height", 1.0}}),
       0.75 * pi + 0.5,
       {"side1", "side2", "bottom", "top"}},
      {feature("washer", "revolution",
               {point(1.0, 0.0), point(3.0, 0.0), point(3.0, 1.0), point(1.0, 1.0)}, {}),
       8 * pi,
       {"side1", "side2", "side3", "side4"}},
      {feature("ball", "revolution", {point(0.0, -2.0), arc(0.0, 2.0, 2.0, 0.0)}, {}),
       32 * pi / 3,
       {"side1"}},
      {feature("spindle", "revolution",
               {point(0.0, 0.0), point(2.0, 0.0), point(1.0, 2.0), point(0.0, 4.0)}, {}),
       // two frusta
       pi / 3 * 2 * (4 + 2 + 1) + pi / 3 * 2 * 1,
       {"side1", "side2", "side3"}},
      {feature("quarter", "revolution",
               {point(1.0, 0.0), point(3.0, 0.0), arc(3.0, 2.0, 4.0, 1.0), point(1.0, 2.0)},
               {{"angle", 90.0}}),
       // Pappus: rectangle 2 x 2 at 2, half disc of radius 1 at 3 + 4 / (3 pi)
       pi / 2 * (8 + pi / 2 * (3 + 4 / (3 * pi))),
       {"side1", "side2", "side3", "side4", "start", "end"}},
      {feature("jaws", "revolution",
               {point(0.0, 0.0), point(2.0, 0.5), point(2.0, 2.0), point(0.0, 2.0)},
               {{"angle", 300.0}}),
       5 * pi / 3 * (2 * 2 * 2 / 2.0 - 0.5 * 2 * 0.5 * 4 / 3),
       {"side1", "side2", "side3", "start", "end"}},
      {feature("half", "revolution", {point(1.0, 0.0), point(2.0, 0.0), point(2.0, 1.0)},
               {{"angle", 180.0}}),
       pi * 0.5 * 5 / 3,
       {"side1", "side2", "side3", "start", "end"}},
      // Arcs about centres beyond the axis and before it, further than their radius reaches.
      {feature("lemon", "revolution", {point(0.0, -1.0), arc(0.0, 1.0, 0.5, 0.0)}, {}),
       // circle through (0, -1), (0.5, 0), (0, 1): centre -0.75, radius 1.25
       2 * pi * ((2.0 / 3) * 1 - 0.75 * (1.25 * 1.25 * std::asin(0.8) - 0.75)),
       {"side1"}},
      {feature("slot", "slot", {{"length", 5.0}, {"width", 2.0}, {"height", 3.0}}),
       3 * (6 + pi),
       {"wall", "wall", "wall", "wall", "bottom", "top"}},
  };
}

std::vector<PlacementSource> placements() {
  return {{},
          {{10.0, -20.0, 5.0}, {}, {}},
          {{1.0, 2.0, 3.0},
           std::array<Scalar, 3>{1.0, 2.0, -0.5},
           std::array<Scalar, 3>{0.3, 0.1, 1.0}}};
}

Feature evaluated_at(FeatureSource source, const PlacementSource& placement) {
  source.placement = placement;
  return evaluate(test::one_feature(source)).features[0];
}

Vec3 random_in(const Box& box, Random& random) {
  const double x = random.uniform(box.lo.x, box.hi.x), y = random.uniform(box.lo.y, box.hi.y);
  return {x, y, random.uniform(box.lo.z, box.hi.z)};
}

TEST(Solid, VolumesAreThoseOfTheFormulas) {
  for (const Sample& s : samples())
    EXPECT_NEAR(Solid(evaluated_at(s.source, placements()[2])).volume(), s.volume, 1e-12 * s.volume)
        << s.source.id;
}

TEST(Solid, ContainsTheShareOfItsBoxThatItsVolumeSays) {
  Random random(17);
  constexpr int kPoints = 100000;
  for (const Sample& s : samples()) {
    for (const PlacementSource& placement : placements()) {
      const Solid solid(evaluated_at(s.source, placement));
      const Vec3 size = solid.bounds().hi - solid.bounds().lo;
      const double box = size.x * size.y * size.z;
      int inside = 0;
      for (int k = 0; k < kPoints; ++k) inside += solid.contains(random_in(solid.bounds(), random));
      const double share = s.volume / box;
      const double deviation = std::sqrt(share * (1 - share) / kPoints);
      EXPECT_NEAR(static_cast<double>(inside) / kPoints, share, 4 * deviation + 1e-9)
          << s.source.id;
    }
  }
}

TEST(Solid, BoundsOfUnrotatedFeaturesAreTight) {
  // Every side of the box is touched: a thin slice just inside it holds points of the solid.
  Random random(23);
  for (const Sample& s : samples()) {
    const Solid solid(evaluated_at(s.source, {}));
    const Box& box = solid.bounds();
    for (int side = 0; side < 6; ++side) {
      bool found = false;
      for (int k = 0; k < 200000 && !found; ++k) {
        Vec3 p = random_in(box, random);
        double* c[] = {&p.x, &p.y, &p.z};
        const double lo[] = {box.lo.x, box.lo.y, box.lo.z}, hi[] = {box.hi.x, box.hi.y, box.hi.z};
        const int axis = side / 2;
        const double slice = 0.01 * (hi[axis] - lo[axis]) * random.uniform();
        *c[axis] = side % 2 == 0 ? lo[axis] + slice : hi[axis] - slice;
        found = solid.contains(p);
      }
      EXPECT_TRUE(found) << s.source.id << " side " << side;
    }
  }
}

TEST(Solid, BoxesRoundAFeatureHoldAllOfIt) {
  Random random(31);
  for (const Sample& s : samples())
    for (const PlacementSource& placement : placements()) {
      const Feature feature = evaluated_at(s.source, placement);
      const Solid solid(feature);
      const std::vector<Box> boxes = boxes_round(feature);
      for (int k = 0; k < 5000; ++k) {
        const Vec3 p = random_in(solid.bounds(), random);
        if (!solid.contains(p)) continue;
        EXPECT_TRUE(std::ranges::any_of(boxes, [&](const Box& box) { return box.contains(p); }))
            << s.source.id;
      }
    }
}

TEST(Solid, BoxesRoundARingLeaveItsHoleFree) {
  const Feature ring = evaluated_at(
      feature("ring", "torus", {{"major_radius", 50.0}, {"minor_radius", 2.0}}), placements()[2]);
  const Vec3 centre = ring.placement.apply({0, 0, 0});
  for (const Box& box : boxes_round(ring))
    EXPECT_FALSE(touch(box, grown({centre, centre}, 23)));  // corners 40 from the centre
  const Feature quarter =
      evaluated_at(feature("quarter", "revolution",
                           {point(48.0, 0.0), point(52.0, 0.0), point(52.0, 4.0), point(48.0, 4.0)},
                           {{"angle", 90.0}}),
                   {});
  for (const Box& box : boxes_round(quarter)) {
    EXPECT_FALSE(touch(box, Box{{0, 0, 0}, {30, 30, 4}}));
    EXPECT_GE(std::min(box.lo.x, box.lo.y), -1e-9) << "nothing beyond its ends";
  }
}

TEST(Solid, FacesAreThoseOfTheTable) {
  for (const Sample& s : samples()) {
    std::vector<std::string> names;
    for (const SolidFace& face : faces_of(evaluated_at(s.source, {}))) names.push_back(face.name);
    EXPECT_EQ(names, s.faces) << s.source.id;
  }
}

/// Where a straight way from a point inside to one outside leaves the solid for the first time
/// that bisection finds.
Vec3 crossing(const Solid& solid, Vec3 inside, Vec3 outside) {
  for (int k = 0; k < 60; ++k) {
    const Vec3 middle = 0.5 * (inside + outside);
    (solid.contains(middle) ? inside : outside) = middle;
  }
  return inside;
}

TEST(Solid, ItsBoundaryLiesOnItsFacesAndEveryFaceIsReached) {
  Random random(29);
  for (const Sample& s : samples()) {
    for (const PlacementSource& placement : placements()) {
      const Solid solid(evaluated_at(s.source, placement));
      std::set<std::size_t> reached;
      for (int k = 0; k < 4000; ++k) {
        const Vec3 in = random_in(solid.bounds(), random);
        const Vec3 out = random_in(solid.bounds(), random);
        if (!solid.contains(in) || solid.contains(out)) continue;
        const Vec3 p = crossing(solid, in, out);
        double nearest = HUGE_VAL;
        for (std::size_t f = 0; f < solid.faces().size(); ++f) {
          const double d = std::fabs(signed_distance(solid.faces()[f].surface, p));
          nearest = std::min(nearest, d);
          if (d < 1e-9) reached.insert(f);
        }
        EXPECT_LT(nearest, 1e-9) << s.source.id;
      }
      // Faces that lie in the sides of an unrotated box cannot be crossed within it.
      if (placement.z_axis) {
        EXPECT_EQ(reached.size(), solid.faces().size()) << s.source.id;
      }
    }
  }
}

TEST(Solid, PlanesPointOutwardsAndOthersAwayFromTheirCentre) {
  Random random(31);
  const double h = 1e-5;
  for (const Sample& s : samples()) {
    const Solid solid(evaluated_at(s.source, placements()[2]));
    for (int k = 0; k < 3000; ++k) {
      const Vec3 in = random_in(solid.bounds(), random), out = random_in(solid.bounds(), random);
      if (!solid.contains(in) || solid.contains(out)) continue;
      const Vec3 p = crossing(solid, in, out);
      for (const SolidFace& face : solid.faces()) {
        if (face.surface.kind != Surface::Kind::Plane) continue;
        if (std::fabs(signed_distance(face.surface, p)) > 1e-9) continue;
        EXPECT_FALSE(solid.contains(p + h * normal(face.surface, p)) &&
                     !solid.contains(p - h * normal(face.surface, p)))
            << s.source.id << " " << face.name;
      }
    }
  }
}

TEST(Solid, SurfacesHaveTheKindOfWhatSweepsThem) {
  using Kind = Surface::Kind;
  const auto kinds = [](const std::string& id) {
    for (const Sample& s : samples()) {
      if (s.source.id != id) continue;
      std::vector<Kind> result;
      for (const SolidFace& face : faces_of(evaluated_at(s.source, {})))
        result.push_back(face.surface.kind);
      return result;
    }
    return std::vector<Kind>{};
  };
  EXPECT_EQ(kinds("washer"),
            (std::vector<Kind>{Kind::Plane, Kind::Cylinder, Kind::Plane, Kind::Cylinder}));
  EXPECT_EQ(kinds("ball"), (std::vector<Kind>{Kind::Sphere}));
  EXPECT_EQ(kinds("lemon"), (std::vector<Kind>{Kind::Torus}));
  EXPECT_EQ(kinds("spindle"), (std::vector<Kind>{Kind::Plane, Kind::Cone, Kind::Cone}));
  EXPECT_EQ(kinds("quarter"), (std::vector<Kind>{Kind::Plane, Kind::Torus, Kind::Plane,
                                                 Kind::Cylinder, Kind::Plane, Kind::Plane}));
  EXPECT_EQ(kinds("bean"), (std::vector<Kind>{Kind::Plane, Kind::Cylinder, Kind::Cylinder,
                                              Kind::Plane, Kind::Plane, Kind::Plane}));
  EXPECT_EQ(kinds("slot"), (std::vector<Kind>{Kind::Plane, Kind::Cylinder, Kind::Plane,
                                              Kind::Cylinder, Kind::Plane, Kind::Plane}));
  EXPECT_EQ(kinds("straight_cone"), (std::vector<Kind>{Kind::Cylinder, Kind::Plane, Kind::Plane}));
}

TEST(Solid, PointsOnTheChordOfAnArcAreNotLost) {
  // A half disc on a rectangle: the chord y = 2 and the chord x = 4 lie inside.
  const Solid dome(evaluated_at(
      feature("dome", "prism",
              {point(0.0, 0.0), point(4.0, 0.0), arc(4.0, 2.0, 5.0, 1.0), arc(0.0, 2.0, 2.0, 4.0)},
              {{"height", 1.0}}),
      {}));
  const Solid pole(evaluated_at(
      feature("pole", "prism", {point(0.0, 0.0), arc(0.0, 2.0, 1.0, 1.0), arc(0.0, 0.0, -1.0, 1.0)},
              {{"height", 1.0}}),
      {}));
  for (int k = 1; k < 1000; ++k) {
    EXPECT_TRUE(dome.contains({0.004 * k, 2, 0.5})) << k;
    EXPECT_TRUE(dome.contains({4, 0.002 * k, 0.5})) << k;
    EXPECT_TRUE(pole.contains({0, 0.002 * k, 0.5})) << k;
  }
  const double s = std::sqrt(0.5);
  for (int turn = 0; turn < 360; ++turn) {
    const double c = std::cos(turn * pi / 180), n = std::sin(turn * pi / 180);
    const auto at = [&](double x, double y) {
      return std::array<double, 2>{c * x - n * y, n * x + c * y};
    };
    const auto a = at(-s, -s), b = at(s, -s), top = at(0, 1), low = at(0, -1);
    const Solid disc(evaluated_at(feature("disc", "prism",
                                          {point(a[0], a[1]), arc(b[0], b[1], low[0], low[1]),
                                           arc(a[0], a[1], top[0], top[1])},
                                          {{"height", 1.0}}),
                                  {}));
    for (int k = 1; k < 20; ++k) {
      const double t = 0.05 * k;
      EXPECT_TRUE(disc.contains({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), 0.5}))
          << turn << " " << k;
    }
  }
}

TEST(Solid, PointsLevelWithCornersAreCountedOnce) {
  const Solid star(
      evaluated_at(feature("star", "prism",
                           {point(0.0, -2.0), point(1.0, 0.0), point(3.0, 0.0), point(1.0, 1.0),
                            point(0.0, 4.0), point(-1.0, 1.0), point(-3.0, 0.0), point(-1.0, 0.0)},
                           {{"height", 1.0}}),
                   {}));
  for (const double y : {0.0, 1.0}) {
    EXPECT_TRUE(star.contains({0, y, 0.5}));
    EXPECT_FALSE(star.contains({-3.5, y, 0.5}));
    EXPECT_FALSE(star.contains({3.5, y, 0.5}));
    EXPECT_FALSE(star.contains({-2.9, 1, 0.5}));
  }
}

// A start and its chord add up to 0, not to the 2.7e-16 of the notch's corner.
TEST(Solid, PointsLevelWithARoundedCornerAreCountedOnce) {
  const Solid notched(
      evaluated_at(feature("notched", "prism",
                           {point(2.0, 0.0), point(1.0, 1.9175341959684145),
                            point(-6.0, 1.9175341959684147), point(-2.0, 2.7115857168698315e-16),
                            point(-6.0, -1.9175341959684138), point(1.0, -1.9175341959684145)},
                           {{"height", 2.0}}),
                   {}));
  for (const double y : {0.0, 1e-16, 2e-16, 3e-16}) {
    EXPECT_FALSE(notched.contains({-5, y, 1})) << y;
    EXPECT_TRUE(notched.contains({-1, y, 1})) << y;
  }
}

TEST(Solid, FarFromTheWorldsOriginItStillHasItsShape) {
  const Solid pin(evaluated_at(feature("pin", "cylinder", {{"radius", 1.0}, {"height", 2.0}}),
                               {{1e6, -1e6, 1e6}, {}, {}}));
  EXPECT_TRUE(pin.contains({1e6 + 0.999999, -1e6, 1e6 + 1}));
  EXPECT_FALSE(pin.contains({1e6 + 1.000001, -1e6, 1e6 + 1}));
  EXPECT_FALSE(pin.contains({1e6, -1e6, 1e6 - 1e-6}));
}

}  // namespace
}  // namespace remeshd
