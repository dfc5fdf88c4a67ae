#include "engine/cellular/boundary_model/unified_edges.h"

#include <gtest/gtest.h>

namespace remeshd {
namespace {

/// Two triangles of one plane, with an edge between them.
kernel::Brep kite() {
  kernel::Brep brep;
  for (const Vec3& p : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}}) {
    brep.vertices.push_back({p});
    brep.points.push_back(p);
  }
  for (const auto& [a, b] :
       {std::array{0, 1}, std::array{1, 2}, std::array{2, 3}, std::array{3, 0}, std::array{0, 2}}) {
    kernel::BrepEdge edge;
    edge.kind = kernel::BrepEdge::Kind::Line;
    edge.vertices = {a, b};
    const Vec3 along = normalised(brep.points[b] - brep.points[a]);
    edge.tangents = {along, along};
    brep.edges.push_back(edge);
  }
  brep.faces.resize(2);
  brep.faces[0].edges = {0, 1, 4};
  brep.faces[0].triangles = {{0, 1, 2}};
  brep.faces[1].edges = {2, 3, 4};
  brep.faces[1].triangles = {{0, 2, 3}};
  return brep;
}

TEST(UnifiedEdges, LeaveOutTheEdgeBetweenFacesOfOneSurface) {
  EXPECT_EQ(find_unified_edges(kite(), {{true, {}, 1}, {true, {}, 1}}).groups, 1);
  const UnifiedEdges of_two_sides = find_unified_edges(kite(), {{true, {}, 1}, {true, {}, -1}});
  EXPECT_EQ(of_two_sides.groups, 2);
  EXPECT_TRUE(of_two_sides.edge[4]);
}

TEST(UnifiedEdges, AreNoneOfFacesThatAreNotSelected) {
  const UnifiedEdges of_one = find_unified_edges(kite(), {{true, {}, 1}, {false, {}, 1}});
  EXPECT_EQ(of_one.groups, 1);
  EXPECT_EQ(of_one.edge, (std::vector<char>{1, 1, 0, 0, 1}));
  EXPECT_EQ(of_one.vertex, (std::vector<char>{1, 1, 1, 0}));
}

}  // namespace
}  // namespace remeshd
