#include "engine/revision/group_figures.h"

#include <gtest/gtest.h>

namespace remeshd {
namespace {

/// A unit square of two facets looking up, and one facet of a wall.
Revision square_and_wall() {
  Revision r;
  for (const Vec3& p : {Vec3{0, 0, 1}, Vec3{1, 0, 1}, Vec3{1, 1, 1}, Vec3{0, 1, 1}, Vec3{0, 0, 0}})
    r.output.mesh.nodes.push_back(p);
  r.output.groups.facets = {{{0, 1, 2}, 0, 1}, {{0, 4, 1}, 0, 0}, {{0, 2, 3}, 0, 1}};
  r.output.groups.facet_groups = {{"hole.wall", "plate.side1"}, {"plate.top"}};
  r.model.features.resize(2);
  r.model.features[0].id = "plate";
  r.model.features[1].id = "hole";
  return r;
}

BoundaryFace face(Surface::Kind kind, double area, std::vector<FaceName> names) {
  BoundaryFace out;
  out.surface.kind = kind;
  out.area = area;
  out.names = std::move(names);
  return out;
}

TEST(GroupFigures, AreCountedFromTheFacets) {
  const auto figures = group_figures(square_and_wall());
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[0].group, "hole.wall+plate.side1");
  EXPECT_EQ(figures[0].nodes, 3U);
  EXPECT_EQ(figures[0].facets, 1U);
  EXPECT_EQ(figures[0].mesh_area, 0.5);
  const GroupFigures& top = figures[1];
  EXPECT_EQ(top.group, "plate.top");
  EXPECT_EQ(top.nodes, 4U);
  EXPECT_EQ(top.facets, 2U);
  EXPECT_DOUBLE_EQ(top.mesh_area, 1);
  EXPECT_NEAR(norm(top.centroid - Vec3{0.5, 0.5, 1}), 0, 1e-15);
  EXPECT_EQ(top.normal, (Vec3{0, 0, 1}));
  EXPECT_FALSE(top.exact_area) << "nothing tells it";
}

TEST(GroupFigures, HaveTheExactAreaOfFacesThatAreTheirsAlone) {
  Revision r = square_and_wall();
  r.cells.boundary.faces = {face(Surface::Kind::Plane, 0.75, {{0, "top"}}),
                            face(Surface::Kind::Plane, 0.5, {{0, "top"}}),
                            face(Surface::Kind::Plane, 9, {{0, "bottom"}})};
  EXPECT_EQ(group_figures(r)[1].exact_area, 1.25);
  EXPECT_FALSE(group_figures(r)[0].exact_area);
}

TEST(GroupFigures, HaveTheExactAreaOfSharedPlanesFromTheReport) {
  Revision r = square_and_wall();
  r.cells.boundary.faces = {face(Surface::Kind::Plane, 1, {{0, "top"}}),
                            face(Surface::Kind::Plane, 7, {{0, "top"}, {1, "top"}})};
  r.report.groups = {{"plate.top", 3, 2.9}};
  EXPECT_EQ(group_figures(r)[1].exact_area, 4.0);
}

TEST(GroupFigures, ClaimNoExactAreaOfACurvedFaceThatIsShared) {
  Revision r = square_and_wall();
  r.cells.boundary.faces = {
      face(Surface::Kind::Plane, 1, {{0, "top"}}),
      face(Surface::Kind::Cylinder, 7, {{0, "top"}, {1, "wall"}, {0, "side1"}})};
  EXPECT_FALSE(group_figures(r)[1].exact_area);
  EXPECT_FALSE(group_figures(r)[0].exact_area);
}

}  // namespace
}  // namespace remeshd
