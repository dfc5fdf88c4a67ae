#include "engine/local_fuse/prisms/parallel_prism_edges.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/local_fuse.h"

namespace remeshd {
namespace {

using kernel::BrepEdge;
using kernel::BrepFace;
using test::block;
using test::cylinder;
using test::feature;
using test::FuseInput;
using test::model_of;
using test::placed;
using test::point;

/// The edges of prisms along z; none until they are asked for.
struct Prisms {
  explicit Prisms(std::vector<FeatureSource> features) : in(model_of(std::move(features))) {}

  /// The node of the outlines at (x, y).
  int node_at(double x, double y) const {
    for (int n = 0; n < static_cast<int>(arrangement.nodes.size()); ++n) {
      const Vec3 p = edges.place(arrangement.nodes[n], 0);
      if (std::hypot(p.x - x, p.y - y) < 1e-9) return n;
    }
    ADD_FAILURE() << "no node at " << x << ' ' << y;
    return 0;
  }
  /// The lengths of the edges that stand at (x, y) in some slabs.
  std::vector<double> upright(double x, double y, int first, int last) {
    std::vector<int> found;
    edges.add_upright(node_at(x, y), first, last, found);
    std::vector<double> lengths;
    for (const int e : found) lengths.push_back(edges[e].length);
    return lengths;
  }

  FuseInput in;
  Sweeps sweeps = *find_sweeps(in.model, in.membership, in.features);
  PlanarArrangement arrangement = *arrange(sweeps, in.membership, in.diagonal);
  Slabs slabs = *Slabs::find(sweeps, arrangement, in.membership, in.diagonal);
  ParallelPrismEdges edges{sweeps, arrangement, slabs};
};

/// A block of 10 x 10 x 4 with another of 4 x 4 x 2 on top, flush with its front at y = -5: the
/// front of the outline is in three pieces.
Prisms block_with_a_flush_one() {
  return Prisms({block("below", 10, 10, 4), placed(block("above", 4, 4, 2), 0, -3, 4)});
}

TEST(ParallelPrismEdges, ALevelEdgeIsMadeOnce) {
  Prisms p({block("b", 10, 10, 4)});
  const int low = p.edges.level(0, 0), high = p.edges.level(0, 1);
  EXPECT_NE(low, high);
  EXPECT_EQ(p.edges.level(0, 0), low);
  EXPECT_EQ(p.edges.level(0, 1), high);
  EXPECT_NEAR(p.edges[low].length, 10, 1e-12);
  EXPECT_NEAR(p.edges[low].points.front().z, 0, 1e-12);
  EXPECT_NEAR(p.edges[high].points.front().z, 4, 1e-12);
}

TEST(ParallelPrismEdges, AnEdgeStandsAsHighAsNothingChangesBesideIt) {
  Prisms p({block("column", 4, 4, 6), placed(block("other", 4, 4, 2), 10, 0, 2)});
  ASSERT_EQ(p.slabs.heights(), 4);
  EXPECT_EQ(p.upright(2, 2, 1, 3), (std::vector{6.0})) << "past the heights of the other";
  EXPECT_EQ(p.upright(8, 2, 1, 3), (std::vector{2.0}));
  Prisms two({block("column", 4, 4, 6), block("inner", 4, 4, 2)});
  EXPECT_EQ(two.upright(2, 2, 1, 2), (std::vector{2.0, 4.0})) << "two features, then one";
}

TEST(ParallelPrismEdges, NoneStandsWhereAWallGoesOnStraight) {
  // Another block first, whose walls are those of nothing else.
  Prisms p({block("beside", 1, 1, 4), placed(block("below", 10, 10, 4), 10, 0, 0),
            placed(block("above", 4, 4, 2), 10, -3, 4)});
  for (const double x : {8.0, 12.0}) {
    EXPECT_EQ(p.upright(x, -5, 1, 1), std::vector<double>{}) << x;
    EXPECT_EQ(p.upright(x, -5, 2, 2), (std::vector{2.0})) << x;
  }
  EXPECT_EQ(p.upright(15, -5, 1, 1), (std::vector{4.0}));
}

TEST(ParallelPrismEdges, OneStandsWhereAWallGoesOnUnderAnotherName) {
  Prisms p({feature("prism", "prism",
                    {point(0., 0.), point(5., 0.), point(10., 0.), point(10., 10.), point(0., 10.)},
                    {{"height", 3.0}})});
  EXPECT_EQ(p.upright(5, 0, 1, 1), (std::vector{3.0})) << "between side1 and side2";
}

TEST(ParallelPrismEdges, LinesAreJoinedWhereNothingElseEndsBetweenThem) {
  for (const bool with_upper : {false, true}) {
    Prisms p = block_with_a_flush_one();
    BrepFace front, bottom, upper;
    for (int piece = 0; piece < static_cast<int>(p.arrangement.pieces.size()); ++piece) {
      const ArrangementEdge& e = p.arrangement.pieces[piece];
      const Vec3 a = p.edges.place(p.arrangement.nodes[e.a], 0),
                 b = p.edges.place(p.arrangement.nodes[e.b], 0);
      if (std::fabs(a.y + 5) > 1e-9 || std::fabs(b.y + 5) > 1e-9) continue;
      const int edge = p.edges.level(piece, 0);
      front.edges.push_back(edge);
      bottom.edges.push_back(edge);
      if (with_upper && std::fabs(a.x + b.x) < 1e-9) upper.edges.push_back(edge);
    }
    ASSERT_EQ(front.edges.size(), 3U);
    const kernel::Brep brep = p.edges.finish({front, bottom, upper});
    if (with_upper) {
      EXPECT_EQ(brep.faces[0].edges.size(), 3U) << "the middle one has a face of its own";
      continue;
    }
    ASSERT_EQ(brep.faces[0].edges.size(), 1U);
    EXPECT_EQ(brep.faces[1].edges, brep.faces[0].edges);
    EXPECT_NEAR(brep.edges[brep.faces[0].edges[0]].length, 10, 1e-12);
  }
}

TEST(ParallelPrismEdges, NodesAndPointsOfACircleAreOnIt) {
  Prisms p({cylinder("c", 2, 3)});
  const int circle = p.edges.level(0, 1);
  BrepFace face;
  face.edges = {circle};
  const kernel::Brep brep = p.edges.finish({face});
  const BrepEdge& edge = brep.edges[circle];
  EXPECT_EQ(edge.kind, BrepEdge::Kind::Circle);
  EXPECT_EQ(edge.chain.front(), edge.chain.back());
  EXPECT_EQ(edge.chain.front(), edge.vertices[0]);
  EXPECT_GE(edge.chain.size(), 9U);
  for (const int n : edge.chain) {
    EXPECT_NEAR(std::hypot(brep.points.at(n).x, brep.points.at(n).y), 2, 1e-12);
    EXPECT_NEAR(brep.points.at(n).z, 3, 1e-12);
  }
  EXPECT_LT(test::largest_turning(edge), 6.01);
  EXPECT_EQ(edge.points.front(), brep.vertices[edge.vertices[0]].position);
  EXPECT_EQ(edge.points.back(), edge.points.front());
}

}  // namespace
}  // namespace remeshd
