#include "engine/cellular/boundary_model/group_rims.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

/// A plate with a rib beside it, whose tops are one plane.
FeatureModel two_in_one_plane(std::vector<GroupSource> groups) {
  ModelSource model = test::model_of(
      {test::block("plate", 20, 10, 4), test::placed(test::block("rib", 10, 6, 4), 15, 0, 0)});
  model.groups = std::move(groups);
  return evaluate(model);
}

/// Faces of the boundary in a plane z = height.
std::vector<BoundaryFace> faces_at(const FeatureModel& model, double height) {
  std::vector<BoundaryFace> found;
  for (const BoundaryFace& face : build_cells(model, kRun).boundary.faces)
    if (face.surface.kind == Surface::Kind::Plane &&
        std::ranges::all_of(face.points,
                            [&](const Vec3& p) { return std::fabs(p.z - height) < 1e-9; }))
      found.push_back(face);
  return found;
}

TEST(GroupRims, WithoutAGroupFacesOfOnePlaneAreOne) {
  EXPECT_EQ(faces_at(two_in_one_plane({}), 4).size(), 1U);
}

TEST(GroupRims, OfAFaceThatAGroupNamesAreEdges) {
  const auto faces = faces_at(two_in_one_plane({{"load", "rib.top & x > 17", {}}}), 4);
  ASSERT_EQ(faces.size(), 2U);
  EXPECT_NEAR(std::fmin(faces[0].area, faces[1].area), 60, 1e-9);
  EXPECT_EQ(faces_at(two_in_one_plane({{"load", "rib.top", {}}}), 0).size(), 1U)
      << "the group names no face of the bottom";
}

TEST(GroupRims, BetweenFacesOfTheSameGroupsAreNone) {
  EXPECT_EQ(faces_at(two_in_one_plane({{"load", "*.top", {}}}), 4).size(), 1U);
  EXPECT_EQ(faces_at(two_in_one_plane({{"load", "*.top", {}}, {"more", "rib.top", {}}}), 4).size(),
            2U);
}

TEST(GroupRims, AreBetweenFacesThatAGroupNamesWithOtherConditions) {
  const FeatureModel model =
      two_in_one_plane({{"load", "plate.top & y > 0 | rib.top & y < 0", {}}});
  EXPECT_EQ(faces_at(model, 4).size(), 2U);
  EXPECT_EQ(faces_at(two_in_one_plane({{"load", "*.top & y > 0", {}}}), 4).size(), 1U);
}

TEST(GroupRims, OfARoundFaceAreCircles) {
  ModelSource model = test::model_of(
      {test::cylinder("shaft", 5, 20), test::placed(test::cylinder("end", 5, 10), 0, 0, 20)});
  model.groups = {{"seat", "end.wall", {}}};
  const BoundaryModel boundary = build_cells(evaluate(model), kRun).boundary;
  const auto at_joint = [](const BoundaryEdge& edge) {
    return edge.curve.kind == Curve::Kind::Circle && std::fabs(edge.curve.origin.z - 20) < 1e-9;
  };
  EXPECT_EQ(std::ranges::count_if(boundary.edges, at_joint), 1);
}

TEST(ChangedRims, AreWhereAGroupHasComeOrGone) {
  const auto boundary = [](const std::vector<GroupSource>& groups) {
    return build_cells(two_in_one_plane(groups), kRun).boundary;
  };
  const BoundaryModel plain = boundary({}), top = boundary({{"load", "rib.top", {}}});
  const auto apart = [](const Vec3&) { return 0.5; };
  EXPECT_TRUE(changed_rims(top, top, apart).empty());
  EXPECT_TRUE(changed_rims(plain, boundary({{"side", "plate.x_min", {}}}), apart).empty())
      << "that face has no neighbour in its plane";
  for (const auto& [a, b] : {std::pair(&plain, &top), std::pair(&top, &plain)}) {
    const std::vector<Vec3> places = changed_rims(*a, *b, apart);
    EXPECT_GE(places.size(), 12U);
    for (const Vec3& p : places) {
      EXPECT_NEAR(p.x, 10, 1e-9);
      EXPECT_LT(std::fabs(p.y), 3);
      EXPECT_NEAR(p.z, 4, 1e-9);
    }
  }
}

}  // namespace
}  // namespace remeshd
