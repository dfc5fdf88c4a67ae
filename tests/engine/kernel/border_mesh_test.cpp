#include "engine/kernel/border_mesh.h"

#include <gtest/gtest.h>

namespace remeshd::kernel {
namespace {

Border square() {
  Border border;
  for (const std::array<double, 2>& p :
       {std::array{0.0, 0.0}, std::array{1.0, 0.0}, std::array{1.0, 1.0}, std::array{0.0, 1.0}})
    border.corners.push_back({.p = p});
  for (int i = 0; i < 4; ++i) border.segments.push_back({.a = i, .b = (i + 1) % 4});
  return border;
}

TEST(MeshBorder, CutsASquareRoundAPointIntoFourTriangles) {
  const std::array<double, 2> centre{0.5, 0.5};
  const auto triangles = mesh_border(square(), {&centre, 1});
  ASSERT_TRUE(triangles);
  EXPECT_EQ(triangles->size(), 4U);
}

TEST(MeshBorder, GivesNothingForASegmentThatEndsWhereItBegins) {
  // As the polyline of a closed edge on which a single node stands.
  Border border = square();
  border.corners.push_back({.p = {0.5, 0.5}});
  border.segments.push_back({.a = 4, .b = 4});
  EXPECT_FALSE(mesh_border(border, {}));
}

TEST(MeshBorder, GivesNothingForTwoSegmentsWithTheSameCorners) {
  Border border = square();
  border.segments.push_back({.a = 1, .b = 0});
  EXPECT_FALSE(mesh_border(border, {}));
}

}  // namespace
}  // namespace remeshd::kernel
