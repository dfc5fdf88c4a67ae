#include "engine/motion/design_velocities.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "engine/local_fuse/local_fuse.h"
#include "engine/motion/carried_boundary.h"
#include "engine/motion/parameter_change.h"
#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

struct Moved {
  const char* model;
  const char* parameter;
  std::uint32_t order = 1;
};

double fastest(const NodalVelocities& v) {
  double most = 0;
  for (const Vec3& each : v.velocities) most = std::max(most, norm(each));
  return most;
}

std::uint32_t undefined(const NodalVelocities& v) {
  return static_cast<std::uint32_t>(std::ranges::count(v.undefined, std::uint8_t{1}));
}

Edit set(const std::string& parameter, double value) {
  const std::size_t dot = parameter.find('.');
  if (dot == std::string::npos) return SetParameter{parameter, value};
  return SetFeatureParameter{parameter.substr(0, dot), parameter.substr(dot + 1), Scalar(value)};
}

class VelocitiesOf : public testing::TestWithParam<Moved> {
 protected:
  const ModelSource source_ = test::case_model(GetParam().model);
  const std::string parameter_ = GetParam().parameter;
  const MeshOptions options_{.nodes = 1500, .order = GetParam().order, .hold = 1};
  const Revision base_ = make_revision(Revision::none(), source_, options_, kRun);
  const DesignVelocities all_{base_, kRun};
  const NodalVelocities v_ = all_.of(parameter_, kRun);
};

// x + t v is on the faces and edges of the model at p + t, to second order.
TEST_P(VelocitiesOf, KeepNodesOnTheMovedModel) {
  EXPECT_EQ(undefined(v_), 0U);
  const double l = base_.edge_length;
  const double t = 1e-4 * l / fastest(v_);
  const FeatureModel model = with_value(source_, parameter_, v_.value + t);
  const CellularModel cells = build_cells(model, kRun);
  const auto match =
      match_carried(base_.cells.boundary, base_.model, cells.boundary, model, 0.3 * l);
  ASSERT_TRUE(match);
  double furthest = 0;
  for (std::size_t n = 0; n < base_.output.mesh.nodes.size(); ++n) {
    const Vec3 x = base_.output.mesh.nodes[n] + t * v_.velocities[n];
    furthest =
        std::max(furthest, distance(x, project(cells.boundary, (*match)(base_.supports()[n]), x)));
  }
  EXPECT_LT(furthest, 1e-6 * l);
}

TEST_P(VelocitiesOf, AreTheLimitOfHeldMeshes) {
  MeshOptions options = options_;
  options.nodes.reset();
  const double t = 5e-4 * base_.edge_length / fastest(v_);
  const Revision held =
      make_revision(base_, apply(source_, {{set(parameter_, v_.value + t)}}), options, kRun);
  ASSERT_EQ(held.report.strategy, MeshStrategy::Morphed);
  const auto check = [&](const CowVector<Vec3>& now, const CowVector<Vec3>& then,
                         std::size_t first) {
    for (std::size_t n = 0; n < now.size(); ++n)
      EXPECT_NEAR(distance((now[n] - then[n]) / t, v_.velocities[first + n]), 0,
                  2e-3 * fastest(v_));
  };
  check(held.output.mesh.nodes, base_.output.mesh.nodes, 0);
  check(held.output.mids.positions, base_.output.mids.positions, base_.output.mesh.nodes.size());
}

TEST_P(VelocitiesOf, GiveTheSameDerivativeForwardAndReverse) {
  std::vector<Vec3> seed(v_.velocities.size());
  double forward = 0;
  for (std::size_t n = 0; n < seed.size(); ++n) {
    const auto k = static_cast<double>(n);
    seed[n] = {std::sin(k), std::cos(3 * k), std::sin(7 * k)};
    forward += dot(seed[n], v_.velocities[n]);
  }
  const auto reverse = all_.gradient(seed, std::vector<std::string>{parameter_}, kRun);
  ASSERT_EQ(reverse.size(), 1U);
  EXPECT_NEAR(reverse[0].value, forward, 1e-6 * fastest(v_) * std::sqrt(seed.size()));
  EXPECT_EQ(reverse[0].undefined, 0U);
}

INSTANTIATE_TEST_SUITE_P(DesignVelocities, VelocitiesOf,
                         testing::Values(Moved{"tool1-a", "pin_radius"},
                                         Moved{"tool1-a", "hole_turn"},
                                         Moved{"tool2-a", "pipe_x", 2},
                                         Moved{"tool2-a", "pipe_outer.radius", 2},
                                         Moved{"tool3-a", "width"}));

/// A mid-node far off the middle of its edge moves along its circle by more than that middle does.
TEST(DesignVelocities, OfMidNodesOnACoarseCircleAreTheLimitOfHeldMeshes) {
  const ModelSource source = test::case_model("detailed/valve");
  MeshOptions options{.nodes = 400, .order = 2, .hold = 1, .sizing = {.even = true}};
  const Revision base = make_revision(Revision::none(), source, options, kRun);
  const NodalVelocities v = DesignVelocities(base, kRun).of("bolt4_0.radius", kRun);
  const double t = 1e-4 * base.edge_length / fastest(v);
  options.nodes.reset();
  const Revision held =
      make_revision(base, apply(source, {{set("bolt4_0.radius", v.value + t)}}), options, kRun);
  ASSERT_EQ(held.report.strategy, MeshStrategy::Morphed);
  const CowVector<Vec3>&now = held.output.mids.positions, &then = base.output.mids.positions;
  for (std::size_t m = 0; m < now.size(); ++m)
    EXPECT_NEAR(distance((now[m] - then[m]) / t, v.velocities[base.output.mesh.nodes.size() + m]),
                0, 2e-3 * fastest(v));
}

TEST(DesignVelocities, OfFacesThatPartAreUndefined) {
  // The base's top is where the wall and the pipe begin and the mounts' holes end.
  const Revision r =
      make_revision(Revision::none(), test::case_model("tool2-a"), {.nodes = 800}, kRun);
  const DesignVelocities all(r, kRun);
  const NodalVelocities v = all.of("base.dz", kRun);
  EXPECT_GT(undefined(v), 20U);
  for (std::size_t n = 0; n < v.undefined.size(); ++n)
    EXPECT_TRUE(v.undefined[n] == 0 || std::fabs(r.output.mesh.nodes[n].z - 12) < 1e-9);
  const std::vector<Vec3> seed(v.velocities.size(), {1, 1, 1});
  EXPECT_GT(all.gradient(seed, std::vector<std::string>{"base.dz"}, kRun)[0].undefined, 0U);
}

TEST(DesignVelocities, FollowTheEdgesWhereAFlatWallTouchesARoundOne) {
  // A slot 14 long and 5 wide: its ends' centres move in as it gets wider, its flat walls out.
  ModelSource source = test::model_of({test::block("base", 30, 20, 6)});
  FeatureSource slot = test::placed(
      test::feature("slot", "slot", {{"length", 14.0}, {"width", 5.0}, {"height", 6.0}}), 0, 0, 0,
      Nature::Subtractive);
  source.features.push_back(slot);
  const Revision r = make_revision(Revision::none(), source, {.nodes = 600}, kRun);
  const NodalVelocities v = DesignVelocities(r, kRun).of("slot.width", kRun);
  EXPECT_EQ(undefined(v), 0U);
  std::size_t found = 0;
  for (std::size_t n = 0; n < r.supports().size(); ++n) {
    const Vec3& p = r.output.mesh.nodes[n];
    if (r.supports()[n].kind != Support::Kind::Edge || std::fabs(std::fabs(p.x) - 4.5) > 1e-9 ||
        std::fabs(std::fabs(p.y) - 2.5) > 1e-9)
      continue;
    ++found;
    EXPECT_NEAR(v.velocities[n].x, p.x > 0 ? -0.5 : 0.5, 1e-6);
    EXPECT_NEAR(v.velocities[n].y, p.y > 0 ? 0.5 : -0.5, 1e-6);
  }
  EXPECT_GT(found, 0U);
}

TEST(DesignVelocities, FollowAnApex) {
  ModelSource cone = test::one_feature(test::feature(
      "cone", "cone", {{"radius_bottom", 10.0}, {"radius_top", 0.0}, {"height", 20.0}}));
  const Revision r = make_revision(Revision::none(), cone, {.nodes = 300}, kRun);
  const NodalVelocities v = DesignVelocities(r, kRun).of("cone.height", kRun);
  EXPECT_EQ(undefined(v), 0U);
  for (std::size_t n = 0; n < r.supports().size(); ++n) {
    const bool apex = r.output.mesh.nodes[n].z > 20 - 1e-9;
    EXPECT_TRUE(!apex || distance(v.velocities[n], Vec3{0, 0, 1}) < 1e-6);
  }
}

TEST(DesignVelocities, AreUndefinedOrAsFastAsWhatMovesWhereAFaceAppears) {
  const ModelSource cone = test::one_feature(test::feature(
      "cone", "cone", {{"radius_bottom", 0.0}, {"radius_top", 5.0}, {"height", 10.0}}));
  const Revision r = make_revision(Revision::none(), cone, {.nodes = 300}, kRun);
  const NodalVelocities v = DesignVelocities(r, kRun).of("cone.radius_bottom", kRun);
  for (std::size_t n = 0; n < r.supports().size(); ++n)
    EXPECT_LT(norm(v.velocities[n]), 10) << "node " << n;
}

TEST(DesignVelocities, OfOneParameterLeaveTheGradientByAnotherAsItIs) {
  // By one of its radii a cylinder becomes a cone: its wall has no motion of its own.
  ModelSource source = test::one_feature(test::feature(
      "post", "cone", {{"radius_bottom", 5.0}, {"radius_top", 5.0}, {"height", 10.0}}));
  source.parameters.push_back({"x", Scalar(0.0)});
  source.features.front().placement.origin = {"x", 0.0, 0.0};
  const Revision r = make_revision(Revision::none(), source, {.nodes = 300}, kRun);
  const DesignVelocities all(r, kRun);
  const std::vector<Vec3> seed(r.output.mesh.nodes.size(), Vec3{1, 0, 0});
  const auto alone = all.gradient(seed, std::vector<std::string>{"x"}, kRun);
  const auto second = all.gradient(seed, std::vector<std::string>{"post.radius_bottom", "x"}, kRun);
  EXPECT_NEAR(alone[0].value, static_cast<double>(seed.size()), 1e-3);
  EXPECT_EQ(second[1].value, alone[0].value);
}

TEST(DesignVelocities, OfAGroupsRimFollowWhatDrawsIt) {
  ModelSource stack = test::model_of(
      {test::block("low", 20, 20, 10), test::placed(test::block("pad", 8, 8, 10), 0, 0, 0)});
  stack.groups.push_back({"load", "pad.top"});
  const Revision r = make_revision(Revision::none(), stack, {.nodes = 400}, kRun);
  const NodalVelocities v = DesignVelocities(r, kRun).of("pad.dx", kRun);
  std::size_t moved = 0;
  for (std::size_t n = 0; n < r.supports().size(); ++n) {
    const Vec3& p = r.output.mesh.nodes[n];
    if (r.supports()[n].kind != Support::Kind::Edge || std::fabs(std::fabs(p.x) - 4) > 1e-9 ||
        std::fabs(p.y) > 4 - 1e-9 || p.z < 10 - 1e-9)
      continue;
    ++moved;
    EXPECT_NEAR(v.velocities[n].x, p.x > 0 ? 0.5 : -0.5, 1e-6);
  }
  EXPECT_GT(moved, 0U);
}

TEST(DesignVelocities, OfAParameterThatTheDocumentLeavesOutAreOfItsDefault) {
  const ModelSource source = test::one_feature(test::feature(
      "ring", "revolution",
      {test::point(4.0, 0.0), test::point(6.0, 0.0), test::point(6.0, 3.0), test::point(4.0, 3.0)},
      {}));
  EXPECT_EQ(parameter_value(source, "ring.angle"), 360);
}

TEST(DesignVelocities, NameWhatIsNoParameter) {
  ModelSource source = test::case_model("tool1-a");
  source.parameters.front().integer = true;
  const Revision r = make_revision(Revision::none(), source, {.nodes = 300}, kRun);
  const DesignVelocities all(r, kRun);
  EXPECT_THROW((void)all.of(source.parameters.front().name, kRun), Error);
  EXPECT_THROW((void)all.of("nothing", kRun), Error);
  EXPECT_THROW((void)all.of("plate.nothing", kRun), Error);
  EXPECT_THROW((void)all.of("nothing.radius", kRun), Error);
}

}  // namespace
}  // namespace remeshd
