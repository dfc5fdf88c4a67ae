#include "engine/cellular/boundary_model/match_boundary.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

BoundaryModel brick(double dx) {
  return build_cells(evaluate(test::one_feature(test::block("b", dx, 3, 4))), kRun).boundary;
}

/// The same boundary with each edge one place further on in its list, the last one first.
BoundaryModel edges_renumbered(BoundaryModel boundary) {
  const auto count = static_cast<int>(boundary.edges.size());
  const auto renumber = [&](std::vector<int>& edges) {
    for (int& e : edges) e = (e + 1) % count;
    std::ranges::sort(edges);
  };
  std::ranges::rotate(boundary.edges, boundary.edges.end() - 1);
  for (BoundaryVertex& vertex : boundary.vertices) renumber(vertex.edges);
  for (BoundaryFace& face : boundary.faces) renumber(face.edges);
  return boundary;
}

TEST(MatchBoundaries, PairsTheEntitiesOfTheSameShapeInAnotherOrder) {
  const BoundaryModel from = brick(2), to = edges_renumbered(brick(2.01));
  const auto match = match_boundaries(from, to, 0.02);
  ASSERT_TRUE(match);
  for (int v = 0; v < 8; ++v) EXPECT_EQ(match->vertices[v], v);
  for (int e = 0; e < 12; ++e) EXPECT_EQ(match->edges[e], (e + 1) % 12);
  for (int f = 0; f < 6; ++f) EXPECT_EQ(match->faces[f], f);
}

TEST(MatchBoundaries, PairNothingFurtherAwayThanReachNorOfAnotherTopology) {
  EXPECT_FALSE(match_boundaries(brick(2), brick(2.1), 0.02));
  const BoundaryModel tube =
      build_cells(evaluate(test::one_feature(test::cylinder("c", 2, 3))), kRun).boundary;
  EXPECT_FALSE(match_boundaries(brick(2), tube, 100));
}

}  // namespace
}  // namespace remeshd
