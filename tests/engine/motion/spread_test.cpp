#include "engine/motion/spread.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "engine/motion/mesh_spread.h"
#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

Vec3 linear(const Vec3& p) {
  return {0.1 + 0.3 * p.x - 0.2 * p.y, 0.4 * p.z, -0.1 * p.x + 0.2 * p.z};
}

class SpreadOfAMesh : public testing::Test {
 protected:
  const Revision r_ =
      make_revision(Revision::none(), test::case_model("tool1-a"), {.nodes = 1500}, kRun);
  const CowVector<Vec3>& nodes_ = r_.output.mesh.nodes;
  const MeshSpread spread_{r_, nodes_, kRun};
};

TEST_F(SpreadOfAMesh, GivesTheInteriorALinearMotionOfTheBoundary) {
  std::vector<Vec3> u(nodes_.size());
  for (std::size_t n = 0; n < u.size(); ++n)
    if (r_.supports()[n].kind != Support::Kind::Interior) u[n] = linear(nodes_[n]);
  spread_.interior().forward(std::vector<NodeMotion>(u.size()), u, kRun);
  ASSERT_FALSE(spread_.interior().nodes().empty());
  for (std::size_t n = 0; n < u.size(); ++n)
    EXPECT_NEAR(distance(u[n], linear(nodes_[n])), 0, 1e-9);
}

TEST_F(SpreadOfAMesh, IsTheSameFromWhereverItBegins) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<NodeMotion> motions(nodes_.size());
  std::vector<Vec3> from_rest(nodes_.size());
  std::vector<Vec3> from_anywhere(nodes_.size());
  std::vector<Vec3> in_steps(nodes_.size());
  for (std::size_t n = 0; n < from_rest.size(); ++n) {
    from_anywhere[n] = {any(random), any(random), any(random)};
    if (r_.supports()[n].kind != Support::Kind::Interior)
      from_rest[n] = from_anywhere[n] = in_steps[n] = linear(nodes_[n]) + from_anywhere[n];
  }
  spread_.interior().forward(motions, from_rest, kRun);
  spread_.interior().forward(motions, from_anywhere, kRun);
  for (int step = 0; step < 5; ++step)
    spread_.interior().forward(motions, in_steps, kRun, Spread::Accuracy::Rough);
  for (std::size_t n = 0; n < from_rest.size(); ++n) {
    EXPECT_NEAR(distance(from_rest[n], from_anywhere[n]), 0, 1e-9);
    EXPECT_NEAR(distance(from_rest[n], in_steps[n]), 0, 1e-9);
  }
}

TEST_F(SpreadOfAMesh, ItsTransposeGivesTheSameProducts) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto vector = [&] { return Vec3{any(random), any(random), any(random)}; };
  std::vector<NodeMotion> motions(nodes_.size());
  std::vector<Vec3> seed(nodes_.size());
  for (std::size_t n = 0; n < seed.size(); ++n) {
    seed[n] = vector();
    const auto kind = r_.supports()[n].kind;
    if (kind == Support::Kind::Interior) continue;
    motions[n].required = vector();
    const Vec3 axis = normalised(vector());
    if (kind == Support::Kind::Face) motions[n].freedom = {Freedom::Kind::Plane, axis};
    if (kind == Support::Kind::Edge) motions[n].freedom = {Freedom::Kind::Line, axis};
    if (kind == Support::Kind::Vertex) motions[n].freedom = {Freedom::Kind::None, {}};
  }
  const std::vector<Vec3> u = spread_.forward(motions, kRun);
  const std::vector<Vec3> back = spread_.reverse(motions, seed, kRun);
  double forward = 0, reverse = 0;
  for (std::size_t n = 0; n < u.size(); ++n) {
    forward += dot(seed[n], u[n]);
    reverse += dot(back[n], motions[n].required);
  }
  EXPECT_NEAR(forward, reverse, 1e-8 * std::fabs(forward));
}

}  // namespace
}  // namespace remeshd
