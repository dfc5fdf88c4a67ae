#include "engine/nodes/active_faces.h"

#include <gtest/gtest.h>

#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;
constexpr double kEdgeLength = 2;

/// A block, 40 x 40 x 10, that gets another of 20 x 20 x 10 on its middle: the face between them is
/// active. Nodes that were fixed at this height, 0.6 edge lengths apart.
CopiedNodes under_the_boss(double z) {
  const FeatureSource base = test::block("base", 40, 40, 10);
  const FeatureModel original = evaluate(test::model_of({base}));
  const FeatureModel modified =
      evaluate(test::model_of({base, test::placed(test::block("boss", 20, 20, 10), 0, 0, 10)}));
  CopiedNodes nodes;
  for (double x = -9; x < 9; x += 0.6 * kEdgeLength)
    for (double y = -9; y < 9; y += 0.6 * kEdgeLength) nodes.add_new({x, y, z});
  // What the boss' other faces are nearest to.
  for (const Vec3& p : {Vec3{-11, 0, 10}, {11, 0, 10}, {0, -11, 10}, {0, 11, 10}, {0, 0, 20}})
    nodes.add_new(p);
  std::ranges::fill(nodes.state, NodeState::Fixed);
  free_at_active_faces(nodes, CopyPlan(original, modified, {kEdgeLength}, kRun), kEdgeLength, kRun);
  nodes.resize(nodes.size() - 5);
  return nodes;
}

TEST(ActiveFaces, FreeNodesThatAreLittleMoreThanHalfAnEdgeLengthApart) {
  const CopiedNodes nodes = under_the_boss(10);
  for (std::int32_t n = 0; n < nodes.size(); ++n)
    EXPECT_TRUE(nodes.is_free(n)) << nodes.positions[n].x << ' ' << nodes.positions[n].y;
}

}  // namespace
}  // namespace remeshd
