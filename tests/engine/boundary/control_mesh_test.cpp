#include "engine/boundary/control_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/base/random.h"
#include "engine/cellular/cellular_model.h"
#include "engine/model/solid.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

struct Built {
  FeatureModel model;
  CellularModel cells;
  Membership membership;
  ControlMesh control;
};

Built build(const FeatureModel& model) {
  CellularModel cells = build_cells(model, kRun);
  ControlMesh control = ControlMesh::build(cells.boundary, kRun);
  return {model, std::move(cells), Membership(model), std::move(control)};
}

/// How far the triangles lie from the surfaces that they stand for, judged at the middles of their
/// sides and at their centroids, where a chord is furthest away; for other places half as much
/// more.
double chord_error(const BoundaryModel& boundary) {
  double most = 0;
  for (const BoundaryFace& f : boundary.faces)
    for (const auto& [i, j, k] : f.triangles) {
      const Vec3 &a = f.points[i], &b = f.points[j], &c = f.points[k];
      for (const Vec3& p : {0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a), (a + b + c) / 3.0})
        most = std::max(most, std::fabs(signed_distance(f.surface, p)));
    }
  return 1.5 * most;
}

double nearest_surface(const BoundaryModel& boundary, const Vec3& p) {
  double least = HUGE_VAL;
  for (const BoundaryFace& f : boundary.faces)
    least = std::min(least, std::fabs(signed_distance(f.surface, p)));
  return least;
}

class ControlMeshOf : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Cases, ControlMeshOf, testing::Values("tool1-a", "tool2-d", "tool3-a"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_P(ControlMeshOf, TheModelHasItsVolumeToWithinTheChords) {
  const Built b = build(test::case_features(GetParam()));
  double curved_area = 0;
  for (const BoundaryFace& f : b.cells.boundary.faces)
    if (f.surface.kind != Surface::Kind::Plane) curved_area += f.area;
  EXPECT_NEAR(b.control.volume(), b.cells.volume,
              curved_area * chord_error(b.cells.boundary) + 1e-9 * b.cells.volume);
  EXPECT_NEAR(b.control.volume(), b.cells.volume, 4e-3 * b.cells.volume);
}

TEST_P(ControlMeshOf, TheModelAgreesWithMembershipExceptWithinAChordOfASurface) {
  const Built b = build(test::case_features(GetParam()));
  const double chord = chord_error(b.cells.boundary);
  const Box& box = b.cells.boundary.bounds;
  Random random(7);
  int inside = 0, differ = 0;
  constexpr int kPoints = 20000;
  for (int i = 0; i < kPoints; ++i) {
    const double x = random.uniform(box.lo.x, box.hi.x), y = random.uniform(box.lo.y, box.hi.y);
    const Vec3 p{x, y, random.uniform(box.lo.z, box.hi.z)};
    const bool in = b.control.inside(p);
    inside += in ? 1 : 0;
    if (in == b.membership.inside(p)) continue;
    ++differ;
    ASSERT_LT(nearest_surface(b.cells.boundary, p), chord)
        << p.x << " " << p.y << " " << p.z << (in ? " wrongly inside" : " wrongly outside");
  }
  EXPECT_LT(differ, kPoints / 200);
  const double in_box =
      b.cells.volume / ((box.hi.x - box.lo.x) * (box.hi.y - box.lo.y) * (box.hi.z - box.lo.z));
  EXPECT_NEAR(static_cast<double>(inside) / kPoints, in_box, 0.015);  // over four deviations
}

TEST_P(ControlMeshOf, TheModelHoldsTheMiddleOfEachOfItsTets) {
  const Built b = build(test::case_features(GetParam()));
  const TetMesh& m = b.control.mesh();
  double volume = 0;
  for (const Tet& t : m.tets) {
    const Vec3 &p = m.nodes[t[0]], &q = m.nodes[t[1]], &r = m.nodes[t[2]], &s = m.nodes[t[3]];
    const double six = dot(cross(q - p, r - p), s - p);
    ASSERT_GT(six, 0);
    volume += six / 6;
    ASSERT_TRUE(b.control.inside((p + q + r + s) / 4.0));
  }
  EXPECT_NEAR(volume, b.control.volume(), 1e-9 * volume);
}

TEST(ControlMesh, OfABlockIsTheBlockUpToItsFaces) {
  const Built b = build(evaluate(
      test::one_feature(test::feature("block", "block", {{"dx", 30.}, {"dy", 20.}, {"dz", 10.}}))));
  EXPECT_NEAR(b.control.volume(), 6000, 1e-6);
  const auto line = [&](const Vec3& from, const Vec3& out) {
    for (const double gap : {1e-8, 1e-3, 1.0, 1e3, 1e300}) {
      EXPECT_FALSE(b.control.inside(from + gap * out)) << gap;
    }
    EXPECT_TRUE(b.control.inside(from));
    EXPECT_TRUE(b.control.inside(from - 1e-8 * out));
    EXPECT_TRUE(b.control.inside(from - 1.0 * out));
  };
  line({15, 3, 4}, {1, 0, 0});
  line({-15, 3, 4}, {-1, 0, 0});
  line({1, 10, 4}, {0, 1, 0});
  line({1, -10, 4}, {0, -1, 0});
  line({1, 3, 10}, {0, 0, 1});
  line({1, 3, 0}, {0, 0, -1});
  EXPECT_FALSE(b.control.inside({NAN, 0, 5}));
  EXPECT_FALSE(b.control.inside({HUGE_VAL, 0, 5}));
}

TEST(ControlMesh, LeavesAVoidOut) {
  ModelSource source =
      test::one_feature(test::feature("block", "block", {{"dx", 30.}, {"dy", 20.}, {"dz", 10.}}));
  FeatureSource bubble = test::feature("bubble", "sphere", {{"radius", 3.}});
  bubble.nature = Nature::Subtractive;
  bubble.placement.origin = {Scalar(0.), Scalar(0.), Scalar(5.)};
  source.features.push_back(bubble);
  const Built b = build(evaluate(source));
  EXPECT_NEAR(b.control.volume(), b.cells.volume, 2e-3 * b.cells.volume);
  EXPECT_FALSE(b.control.inside({0, 0, 5}));
  EXPECT_FALSE(b.control.inside({0, 0, 7.9}));
  EXPECT_TRUE(b.control.inside({0, 0, 8.1}));
}

TEST(ControlMesh, JoinsTheFacesOfABlockAtItsEightCorners) {
  const Built b = build(evaluate(
      test::one_feature(test::feature("block", "block", {{"dx", 30.}, {"dy", 20.}, {"dz", 10.}}))));
  const kernel::TetGenSurface s = joined_surface(b.cells.boundary);
  EXPECT_EQ(s.points.size(), 8U);
  EXPECT_EQ(s.triangles.size(), 12U);
}

TEST(ControlMesh, OfABoundaryWithAHoleInItIsRefused) {
  BoundaryModel boundary = build_cells(test::case_features("tool1-a"), kRun).boundary;
  boundary.faces[2].triangles.pop_back();
  EXPECT_EQ(test::error_of([&] { ControlMesh::build(boundary, kRun); }).reason, "TETGEN_REFUSED");
  EXPECT_EQ(test::error_of([&] { ControlMesh::build({}, kRun); }).reason, "TETGEN_REFUSED");
}

}  // namespace
}  // namespace remeshd
