#include "engine/remesh/morph/morph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "engine/mesh/tet_boxes.h"
#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"
#include "tests/support/stored.h"

namespace remeshd {
namespace {

using test::kRun;

constexpr MeshOptions kOfMorphs{.nodes = 3000};

ModelSource with(ModelSource source, const std::string& feature, const std::string& parameter,
                 double more) {
  for (FeatureSource& f : source.features)
    if (f.id == feature) {
      Scalar& value = f.parameters.at(parameter);
      value = std::get<double>(value) + more;
    }
  return source;
}

ModelSource grown(const ModelSource& tool1, double by) {
  return with(tool1, "plate", "radius", by);
}

double largest_motion(const Revision& a, const Revision& b) {
  double largest = 0;
  for (std::size_t n = 0; n < a.output.mesh.nodes.size(); ++n)
    largest = std::max(largest, distance(a.output.mesh.nodes[n], b.output.mesh.nodes[n]));
  return largest;
}

class Continuation : public testing::Test {
 protected:
  Revision edit(const Revision& original, const ModelSource& source) const {
    return make_revision(original, source, {}, kRun);
  }
  const ModelSource source_ = test::case_model("tool1-a");
  const Revision base_ = make_revision(Revision::none(), source_, kOfMorphs, kRun);
  const double l_ = base_.edge_length;
};

TEST_F(Continuation, KeepsTheConnectivityBelowAHundredthOfTheEdgeLength) {
  for (const double step : {1e-9, 1e-6, 1e-4, 0.0099}) {
    SCOPED_TRACE(step);
    const Revision r = edit(base_, grown(source_, step * l_));
    EXPECT_EQ(r.report.strategy, MeshStrategy::Morphed);
    EXPECT_EQ(r.output.mesh.tets, base_.output.mesh.tets);
    EXPECT_EQ(r.output.node_ids, base_.output.node_ids);
    const double moved = largest_motion(base_, r);
    EXPECT_GE(moved, 0.999 * step * l_);
    EXPECT_LE(moved, 5 * step * l_);
    EXPECT_GE(r.report.quality.dihedral_min,
              std::min(25.0, base_.report.quality.dihedral_min - 0.1));
  }
  EXPECT_EQ(edit(base_, grown(source_, 0.011 * l_)).report.strategy, MeshStrategy::Local);
}

TEST_F(Continuation, MovesNothingFurtherThanThreeEdgeLengthsFromWhatMoved) {
  const Revision r = edit(base_, grown(source_, 0.009 * l_));
  ASSERT_EQ(r.report.strategy, MeshStrategy::Morphed);
  std::uint32_t moved = 0;
  for (std::size_t n = 0; n < r.output.mesh.nodes.size(); ++n) {
    const Vec3& before = base_.output.mesh.nodes[n];
    if (r.output.mesh.nodes[n] == before) {
      EXPECT_EQ(r.output.map.node_origin[n], NodeOrigin::Kept);
      continue;
    }
    ++moved;
    EXPECT_EQ(r.output.map.node_origin[n], NodeOrigin::Moved);
    EXPECT_LT(50 - std::hypot(before.x, before.y), 3.01 * l_);  // the plate's wall
  }
  EXPECT_GT(moved, 100U);
  EXPECT_LT(moved, r.output.mesh.nodes.size() / 2);
}

TEST_F(Continuation, EndsInOneStepOrManyAtTheSamePlace) {
  const Revision at_once = edit(base_, grown(source_, 0.01));
  Revision step = edit(base_, grown(source_, 0.004));
  step = edit(step, grown(source_, -0.003));
  step = edit(step, grown(source_, 0.01));
  EXPECT_EQ(step.output.mesh.nodes, at_once.output.mesh.nodes);
  // And back where it began the mesh is what it was.
  const Revision back = edit(step, source_);
  EXPECT_EQ(back.output.mesh.nodes, base_.output.mesh.nodes);
}

TEST_F(Continuation, CountsFromTheModelThatTheConnectivityWasMadeFor) {
  Revision r = edit(base_, grown(source_, 0.007 * l_));
  EXPECT_EQ(r.report.strategy, MeshStrategy::Morphed);
  r = edit(r, grown(source_, 0.014 * l_));
  EXPECT_EQ(r.report.strategy, MeshStrategy::Local);
}

TEST_F(Continuation, ARemeshFromIncludesWhatFollowedBefore) {
  const Revision moved = edit(base_, grown(source_, 0.009 * l_));
  ASSERT_EQ(moved.report.strategy, MeshStrategy::Morphed);
  ModelSource further = grown(source_, 0.009 * l_);
  further = apply(further, test::case_edit("tool1-ac"));
  const Revision remesh = edit(moved, further);
  EXPECT_EQ(remesh.report.strategy, MeshStrategy::Local);
  EXPECT_GT(remesh.report.counts.nodes_kept, remesh.report.counts.nodes / 3);
  EXPECT_TRUE(verify(remesh.output.mesh, remesh.supports(), remesh.cells.boundary,
                     remesh.cells.volume, kRun)
                  .valid);
}

TEST_F(Continuation, InMemoryEqualsLoadedAgain) {
  const Revision moved = edit(base_, grown(source_, 0.009 * l_));
  ASSERT_EQ(moved.report.strategy, MeshStrategy::Morphed);
  const Revision loaded = test::stored_and_loaded(moved);
  for (const double by : {0.005, 0.5}) {
    const ModelSource next = grown(source_, by);
    EXPECT_EQ(test::stored_bytes(edit(moved, next)), test::stored_bytes(edit(loaded, next)));
  }
}

/// A block of 10 x 10 x 10 whose mesh is one tet, with a node on the side x = 10. Its largest
/// dihedral angle is 144.97 degrees, its volume-length 0.313; where the sides go out by 0.01 it is
/// 145.08, and all else is next to what it was.
struct OneTet {
  static Revision of(double out, double edge_length) {
    Revision r;
    r.source = test::one_feature(test::placed(test::block("block", 10 + 2 * out, 10, 10), 5, 5, 0));
    r.model = r.meshed_model = evaluate(r.source);
    r.cells = build_cells(r.model, kRun);
    r.edge_length = edge_length;
    return r;
  }
  explicit OneTet(double edge_length) : original(of(0, edge_length)) {
    const BoundaryModel& boundary = original.cells.boundary;
    int side = 0;
    while (boundary.faces[side].surface.kind != Surface::Kind::Plane ||
           std::fabs(signed_distance(boundary.faces[side].surface, {10, 1, 2})) > 1e-9)
      ++side;
    const TetMesh mesh{{{9.1, 5, 8.3}, {3.4, 7, 4.3}, {7.2, 8.6, 2.1}, {10, 6.5, 3}},
                       {{0, 1, 2, 3}}};
    original.output.mesh = paged(mesh);
    original.boxes = boxes_round(original.output.mesh);
    original.anchor = std::make_shared<const Anchor>(
        Anchor{original.source, original.model, original.output.mesh.nodes,
               CowVector(std::vector<Support>{{}, {}, {}, {Support::Kind::Face, side}})});
  }
  /// Why the tet is not kept where the sides go out. It never is: alone it is no mesh of a block.
  std::string refused(double by) const {
    const auto result = morph_mesh(original, of(by, original.edge_length), kRun);
    const auto* why = std::get_if<NotMorphed>(&result);
    return why != nullptr ? *why : "kept";
  }

  Revision original;
};

TEST(Morph, NoLargestAngleGoesBeyondItsGoal) {
  constexpr const char* kMissed = "a tet would have missed the goals of quality";
  const OneTet tet(1.1);
  EXPECT_EQ(tet.refused(0.01), kMissed);
  EXPECT_NE(tet.refused(0.001), kMissed) << "144.98 degrees";
}

/// A thousand steps of 1e-4 l: as good as fresh, and the boundary where it should be.
TEST(Continuations, AThousandTinyStepsNeitherDriftNorDecay) {
  constexpr int kSteps = 1000;
  const ModelSource source = test::case_model("simple-a");
  const Revision base = make_revision(Revision::none(), source, kOfMorphs, kRun);
  Revision r = base;
  int continued = 0;
  for (int k = 1; k <= kSteps; ++k) {
    // Each of the two sides moves by half of what the width grows.
    r = make_revision(r, with(source, "base", "dx", k * 2e-4 * base.edge_length), {}, kRun);
    continued += r.report.strategy == MeshStrategy::Morphed;
    ASSERT_LE(r.report.strategy, MeshStrategy::Local) << k;
  }
  EXPECT_GE(continued, kSteps - 20);
  const Revision fresh =
      make_revision(Revision::none(), r.source, {.nodes = r.report.counts.nodes}, kRun);
  EXPECT_NEAR(r.report.counts.nodes, base.report.counts.nodes, 0.02 * 3000);
  EXPECT_NEAR(r.report.quality.volume_length_mean, fresh.report.quality.volume_length_mean, 0.01);
  EXPECT_GE(r.report.quality.dihedral_min, 25);
  EXPECT_NEAR(r.report.volume, r.cells.volume, 1e-9 * r.cells.volume);
  EXPECT_TRUE(verify(r.output.mesh, r.supports(), r.cells.boundary, r.cells.volume, kRun).valid);
}

}  // namespace
}  // namespace remeshd
