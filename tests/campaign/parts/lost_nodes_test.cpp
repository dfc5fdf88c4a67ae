#include "tests/campaign/parts/lost_nodes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"

namespace remeshd::campaign {
namespace {

/// A bar from x = -50 to 50 with a hole at `x`.
ModelSource bar(double x, double radius) {
  return test::model_of(
      {test::block("bar", 100, 12, 6),
       test::placed(test::cylinder("hole", radius, 8), x, 0, -1, Nature::Subtractive)});
}

/// What an edit says that it kept: all nodes but those that `lost` takes.
template <class Lost>
Revision edited(const Revision& base, const ModelSource& model, const Lost& lost) {
  Revision made = make_revision(base, model, {}, {});
  const CowVector<Vec3>& nodes = base.output.mesh.nodes;
  NodeMap map;
  for (std::int32_t n = 0; n < static_cast<std::int32_t>(nodes.size()); ++n) {
    map.node_origin.push_back(lost(nodes[n]) ? NodeOrigin::New : NodeOrigin::Kept);
    map.original_node.push_back(n);
  }
  made.output.map = map;
  return made;
}

struct LostNodesTest : testing::Test {
  MeshOptions options{.nodes = 700};
  const Revision base = make_revision(Revision::none(), bar(-30, 2), options, {});
  const double l = base.edge_length;
  const ModelSource wider = bar(-30, 2.5);
};

TEST_F(LostNodesTest, NearAChangeAreNotFar) {
  const Revision next =
      edited(base, wider, [&](const Vec3& p) { return std::fabs(p.x + 30) < 2.5 + 4 * l; });
  const LostNodes lost = lost_nodes(base, next);
  EXPECT_GT(lost.all, 50);
  EXPECT_EQ(lost.far, 0);
}

TEST_F(LostNodesTest, OneFurtherThanSixLengthsFromTheChangeIsFar) {
  // The corner, 77.5 from the wall of the wider hole but for half the width of the bar.
  const Vec3 corner{50, 6, 6};
  const Revision next =
      edited(base, wider, [&](const Vec3& p) { return distance(p, corner) < 1e-9; });
  const LostNodes lost = lost_nodes(base, next);
  EXPECT_EQ(lost.all, 1);
  EXPECT_EQ(lost.far, 1);
  EXPECT_NEAR(lost.furthest * l, 77.5, 1.0);
  EXPECT_LE(lost.furthest * l, distance(corner, {-27.5, 0, 6}));
}

TEST_F(LostNodesTest, OnesThatAChangeCutAwayAreNotFar) {
  // 40 of the bar's 100 go, and nothing else is lost.
  ModelSource shorter = bar(-30, 2);
  shorter.features[0].parameters["dx"] = 70.0;
  shorter.features[0].placement.origin[0] = -15.0;
  const Revision next = edited(base, shorter, [](const Vec3& p) { return p.x > 20; });
  const LostNodes lost = lost_nodes(base, next);
  EXPECT_GT(lost.all, 100);
  EXPECT_EQ(lost.far, 0);
}

TEST_F(LostNodesTest, AreAllNowhereNearWhereNothingChanged) {
  const Revision next = edited(base, bar(-30, 2), [](const Vec3& p) { return p.x > 20; });
  const LostNodes lost = lost_nodes(base, next);
  EXPECT_GT(lost.all, 0);
  EXPECT_EQ(lost.far, lost.all);
  EXPECT_EQ(lost.furthest, kNowhere);
}

TEST_F(LostNodesTest, ThatMovedAreLost) {
  Revision next = make_revision(base, wider, {}, {});
  const int before = lost_nodes(base, next).all;
  for (std::size_t n = 0; n < next.output.map.node_origin.size(); ++n)
    if (next.output.map.node_origin[n] == NodeOrigin::Kept) {
      next.output.map.node_origin.edit(n) = NodeOrigin::Moved;
      break;
    }
  EXPECT_EQ(lost_nodes(base, next).all, before + 1);
}

TEST_F(LostNodesTest, OfARemeshLieNearItsChange) {
  const Revision next = make_revision(base, wider, {}, {});
  ASSERT_EQ(next.report.strategy, MeshStrategy::Local);
  const LostNodes lost = lost_nodes(base, next);
  EXPECT_GT(lost.all, 0);
  EXPECT_EQ(lost.far, 0);
}

TEST_F(LostNodesTest, OfARemeshAfterAMorphLieNearItsOwnChange) {
  const auto two_holes = [](double left, double right) {
    ModelSource model = bar(-30, left);
    model.features.push_back(
        test::placed(test::cylinder("right", right, 8), 30, 0, -1, Nature::Subtractive));
    return model;
  };
  struct Start {
    std::uint32_t nodes;
    std::uint64_t seed;
  };
  // In the last two the morph flips tets of cavities.
  for (const auto& [nodes, seed] : {Start{700, 1}, {1000, 31}, {1000, 39}}) {
    const MeshOptions sized{.nodes = nodes, .seed = seed, .sizing = {.even = false}};
    const MeshOptions inherited{.seed = seed, .sizing = {.even = false}};
    const Revision first = make_revision(Revision::none(), two_holes(2, 2), sized, {});
    const Revision morphed = make_revision(first, two_holes(2.001, 2), inherited, {});
    ASSERT_EQ(morphed.report.strategy, MeshStrategy::Morphed);
    ASSERT_GT(lost_nodes(first, morphed).all, 0);
    const Revision next = make_revision(morphed, two_holes(2.001, 2.5), inherited, {});
    ASSERT_EQ(next.report.strategy, MeshStrategy::Local);
    EXPECT_GT(lost_nodes(morphed, next).all, 0);
    EXPECT_EQ(lost_nodes(morphed, next).far, 0) << "seed " << seed;
  }
}

}  // namespace
}  // namespace remeshd::campaign
