#include "engine/remesh/finish/repair.h"

#include <gtest/gtest.h>

#include "engine/cellular/cellular_model.h"
#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;
constexpr double kEdgeLength = 5;

/// A straight model edge of simple-a with nodes at two places of it, and a chain broken there.
class BrokenLink : public testing::Test {
 protected:
  BrokenLink() {
    while (cells_.boundary.edges[edge_].curve.kind != Curve::Kind::Line) ++edge_;
    const auto& points = cells_.boundary.edges[edge_].points;
    const Vec3 along = normalised(points.back() - points.front());
    a_ = points.front() + 20.0 * along;
    b_ = a_ + kEdgeLength * along;
    for (const Vec3& p : {a_, b_}) nodes_.add_new(p, {Support::Kind::Edge, edge_});
    verification_.failures = {{MeshFailure::MissingSegment, edge_, 0.5 * (a_ + b_), "broken"}};
  }
  int insert() {
    return insert_where_missing(nodes_, verification_.failures, cells_.boundary, samples_,
                                kEdgeLength);
  }

  const FeatureModel model_ = evaluate(test::case_model("simple-a"));
  const CellularModel cells_ = build_cells(model_, kRun);
  const Samples samples_ =
      sample_boundary(cells_.boundary, Membership(model_), kEdgeLength, 1, {}, kRun);
  int edge_ = 0;
  Vec3 a_, b_;
  NodeSet nodes_;
  Verification verification_;
};

TEST_F(BrokenLink, IsHalvedOnItsModelEdge) {
  ASSERT_EQ(insert(), 1);
  EXPECT_EQ(nodes_.supports.back(), (Support{Support::Kind::Edge, edge_}));
  EXPECT_LT(distance(nodes_.positions.back(), 0.5 * (a_ + b_)), 1e-9);
}

TEST_F(BrokenLink, TooShortToBeHalvedGetsANodeWhereSamplesAreFarthestFromAny) {
  nodes_.add_new(0.5 * (a_ + b_), {Support::Kind::Edge, edge_});
  ASSERT_EQ(insert(), 1);
  const Vec3 p = nodes_.positions.back();
  EXPECT_NE(nodes_.supports.back().kind, Support::Kind::Interior);
  EXPECT_LE(distance(p, 0.5 * (a_ + b_)), kEdgeLength);
  EXPECT_GT(distance(p, 0.5 * (a_ + b_)), 0.8 * kEdgeLength);
}

TEST_F(BrokenLink, IsLeftAloneWhereNothingIsMissing) {
  verification_.failures.clear();
  EXPECT_EQ(insert(), 0);
}

TEST_F(BrokenLink, IsLeftAloneWhereThePartHasNoNodes) {
  nodes_.resize(0);
  EXPECT_EQ(insert(), 0);
}

TEST(Repair, OfAPartThatNothingIsInGoesOnInALargerOne) {
  // A corner of the block stands out of the ring beside the post, by so little that no sample finds
  // it: no node is freed.
  FeatureSource ring =
      test::feature("ring", "revolution",
                    {test::point(0.69, 0.0), test::point(3.1, 0.0), test::point(3.1, 1.1),
                     test::point(1.5, 1.1), test::point(1.5, 2.8), test::point(0.69, 2.8)},
                    {{"angle", 360.0}});
  const FeatureSource post = test::placed(test::cylinder("post", 0.38, 1.5), -0.87, -2.1, 0.69);
  FeatureSource block =
      test::turned(test::placed(test::block("block", 0.71, 0.45, 0.22), -0.87, -2.1, 0.95),
                   {-0.0517814985816592, -0.13907971379375925, 0.9889264429752517},
                   {-0.34505289105670045, -0.9267761390913646, -0.1484065038477639});
  block.reference = ReferenceKind::Centre;
  const ModelSource model = test::model_of({ring, post});
  const Revision base = make_revision(Revision::none(), model, {.nodes = 300, .seed = 53}, kRun);
  const Revision edited =
      make_revision(base, apply(model, ModelEdit{{AddFeature{block, ""}}}), {.seed = 53}, kRun);
  EXPECT_FALSE(edited.output.mesh.tets.empty());
}

TEST(Repair, IsFollowedByTheCleanUp) {
  // So coarse that the boundary is not all there at first.
  int repaired = 0;
  for (const std::uint32_t nodes : {60U, 80U, 150U, 200U}) {
    const Report report =
        make_revision(Revision::none(), test::case_model("tool1-a"),
                      {.nodes = nodes, .iterations = 4, .start = MeshOptions::Start::Random}, kRun)
            .report;
    ASSERT_EQ(report.strategy, MeshStrategy::Local) << nodes;
    repaired += report.counts.nodes_inserted > 0 ? 1 : 0;
    EXPECT_LT(report.quality_before.volume_length_min, 0.1) << nodes << ": slivers before";
    EXPECT_GT(report.quality.volume_length_min, 0.2) << nodes;
  }
  EXPECT_GE(repaired, 2);
}

}  // namespace
}  // namespace remeshd
