#include "engine/delivery/failure_place.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using Names = std::vector<std::string>;

using test::kRun;

class FailureInTool1 : public testing::Test {
 protected:
  FailurePlace find(const MeshDefect& defect) {
    return find_failure(defect, model_, membership_, cells_.boundary, 3);
  }
  /// The model edge through a place.
  int edge_at(const Vec3& p) {
    int best = 0;
    for (int e = 0; e < static_cast<int>(cells_.boundary.edges.size()); ++e)
      if (distance(p, project(cells_.boundary, cells_.boundary.edges[e], p)) <
          distance(p, project(cells_.boundary, cells_.boundary.edges[best], p)))
        best = e;
    return best;
  }

  const FeatureModel model_ = test::case_features("tool1-a");
  const CellularModel cells_ = build_cells(model_, kRun);
  const Membership membership_{model_};
};

TEST_F(FailureInTool1, OnAModelEdgeIsBetweenItsFaces) {
  const Vec3 rim{41, 0, 12};  // of hole1, at 36 with radius 5
  const MeshDefect defect{MeshFailure::MissingSegment, edge_at(rim), rim, "a gap at (41, 0, 12)"};
  const FailurePlace place = find(defect);
  EXPECT_EQ(place.features, (Names{"plate", "hole1"}));
  EXPECT_EQ(describe(defect, place), "a gap at (41, 0, 12), between plate.top and hole1.wall");
}

/// Of a block's corner, where three edges have two faces each.
TEST(FailureOfABlock, AtAModelVertexIsBetweenItsThreeFaces) {
  const FeatureModel model = evaluate(test::model_of({test::block("block", 10, 10, 10)}));
  const CellularModel cells = build_cells(model, kRun);
  const Membership membership(model);
  for (int v = 0; v < 8; ++v) {
    const Vec3& corner = cells.boundary.vertices[v].position;
    Names faces{corner.x < 0 ? "block.x_min" : "block.x_max",
                corner.y < 0 ? "block.y_min" : "block.y_max",
                corner.z < 5 ? "block.bottom" : "block.top"};
    const MeshDefect defect{MeshFailure::MissingVertex, v, corner, "no node"};
    EXPECT_THAT(find_failure(defect, model, membership, cells.boundary, 3).faces,
                testing::UnorderedElementsAreArray(faces));
  }
}

TEST_F(FailureInTool1, OnOneFaceIsOnIt) {
  const MeshDefect defect{
      MeshFailure::NonconformingFacet, 7, {0, 49.9, 6}, "a stray facet at (0, 49.9, 6)"};
  const FailurePlace place = find(defect);
  EXPECT_EQ(place.faces, Names{"plate.wall"});
  EXPECT_EQ(describe(defect, place), "a stray facet at (0, 49.9, 6), on plate.wall");
}

TEST_F(FailureInTool1, NearTwoFacesNamesTheNearerFirst) {
  const FailurePlace place = find({MeshFailure::BadTet, 7, {0, 49.5, 11}, "a flat tet"});
  EXPECT_EQ(place.faces, (Names{"plate.wall", "plate.top"}));
  EXPECT_EQ(place.features, Names{"plate"});
}

TEST_F(FailureInTool1, OfTheWholeMeshHasNoPlace) {
  const MeshDefect defect{MeshFailure::Volume, -1, {}, "the volume is wrong"};
  EXPECT_TRUE(find(defect).faces.empty());
  EXPECT_EQ(describe(defect, find(defect)), "the volume is wrong");
}

}  // namespace
}  // namespace remeshd
