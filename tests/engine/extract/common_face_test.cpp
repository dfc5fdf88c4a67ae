#include "engine/extract/common_face.h"

#include <gtest/gtest.h>

#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"

namespace remeshd {
namespace {

const remeshd::Run kRun;  // GoogleTest's fixtures have a Run of their own

TEST(FacesOf, AVertexOfABlockLiesOnThreeFacesAnEdgeOnTwo) {
  const CellularModel cells = build_cells(
      evaluate(
          test::one_feature(test::feature("b", "block", {{"dx", 2.0}, {"dy", 3.0}, {"dz", 4.0}}))),
      kRun);
  const FacesOf faces(cells.boundary);
  ASSERT_EQ(cells.boundary.vertices.size(), 8U);
  for (int v = 0; v < 8; ++v) EXPECT_EQ(faces({Support::Kind::Vertex, v}).size(), 3U);
  for (int e = 0; e < 12; ++e) EXPECT_EQ(faces({Support::Kind::Edge, e}).size(), 2U);
  EXPECT_EQ(faces({Support::Kind::Face, 4}).size(), 1U);
  EXPECT_TRUE(faces({}).empty());
}

TEST(FacesOf, OppositeFacesOfABlockShareNoneWithAVertexOfOne) {
  const CellularModel cells = build_cells(
      evaluate(
          test::one_feature(test::feature("b", "block", {{"dx", 2.0}, {"dy", 3.0}, {"dz", 4.0}}))),
      kRun);
  const FacesOf faces(cells.boundary);
  for (int v = 0; v < 8; ++v) {
    const Support vertex{Support::Kind::Vertex, v};
    int shared = 0;
    for (int f = 0; f < 6; ++f) {
      const std::array<Support, 2> pair{vertex, Support{Support::Kind::Face, f}};
      const int common = faces.common(pair);
      if (common >= 0) {
        EXPECT_EQ(common, f);
        ++shared;
      }
    }
    EXPECT_EQ(shared, 3);
  }
}

TEST(FacesOf, TheApexOfAConeLiesOnItsWall) {
  const CellularModel cells = build_cells(
      evaluate(test::one_feature(test::feature(
          "c", "cone", {{"radius_bottom", 2.0}, {"radius_top", 0.0}, {"height", 4.0}}))),
      kRun);
  ASSERT_EQ(cells.boundary.vertices.size(), 1U);
  const FacesOf faces(cells.boundary);
  const auto at_apex = faces({Support::Kind::Vertex, 0});
  ASSERT_EQ(at_apex.size(), 1U);
  EXPECT_EQ(cells.boundary.faces[at_apex[0]].surface.kind, Surface::Kind::Cone);
}

}  // namespace
}  // namespace remeshd
