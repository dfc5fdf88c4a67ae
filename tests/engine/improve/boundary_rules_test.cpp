#include "engine/improve/boundary_rules.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace remeshd {
namespace {

constexpr double kAnyChord = 10;  ///< a tolerance that leaves the rest of the rules to decide
constexpr double kHeight = 1.5;

/// On a wall of radius 1, at an angle round it in degrees.
Vec3 on_wall(double degrees, double z) {
  const double t = degrees * std::numbers::pi / 180;
  return {std::cos(t), std::sin(t), z};
}

/// Two tets of a pin of radius 1 at the edge 0-1 along its wall, their facets between this and the
/// nodes 2 and 3; node 4 is on the axis.
struct Pin {
  explicit Pin(double last_degrees) {
    boundary.faces.emplace_back().surface = {.kind = Surface::Kind::Cylinder, .r1 = 1};
    start.nodes = {on_wall(87.5, -kHeight), on_wall(87.5, kHeight), on_wall(0, 0),
                   on_wall(last_degrees, 0), Vec3{0, 0, 0}};
    start.tets = {{0, 1, 4, 2}, {0, 1, 3, 4}};
    for (int n = 0; n < 4; ++n) supports[n] = {Support::Kind::Face, 0};
  }
  BoundaryModel boundary;
  TetMesh start;
  std::array<Support, 5> supports;
  LocalMesh mesh() const { return LocalMesh(start); }
};

bool may_swap(double last_degrees) {
  const Pin pin(last_degrees);
  const LocalMesh mesh = pin.mesh();
  EdgeRing ring;
  EXPECT_TRUE(mesh.ring(0, 1, 8, ring) && !ring.closed);
  return BoundaryRules(pin.boundary, pin.supports, mesh, kAnyChord).may_swap(0, 1, ring);
}

TEST(BoundaryRules, AnEdgeIsNotSwappedForOneThroughTheMiddleOfAPin) {
  EXPECT_TRUE(may_swap(140));
  EXPECT_FALSE(may_swap(175)) << "verification would find a facet off its face";
}

TEST(BoundaryRules, ANodeDoesNotSlideToWhereItsFacetLeavesItsFace) {
  const Pin pin(140);
  const LocalMesh mesh = pin.mesh();
  const BoundaryRules rules(pin.boundary, pin.supports, mesh, kAnyChord);
  const std::array<Triangle, 1> facet{{{2, 3, 1}}};
  EXPECT_TRUE(rules.may_move(3, on_wall(150, 0), facet));
  EXPECT_FALSE(rules.may_move(3, on_wall(175, 0), facet));
}

}  // namespace
}  // namespace remeshd
