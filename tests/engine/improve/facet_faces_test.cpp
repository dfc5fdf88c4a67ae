#include <gtest/gtest.h>

#include "engine/cellular/cellular_model.h"
#include "engine/improve/boundary_rules.h"
#include "tests/support/cases.h"

namespace remeshd {
namespace {

const remeshd::Run kRun;

/// A strip of the small cylinder's wall, 0.73 wide, stands out of the large one's by 0.01.
BoundaryModel strip_on_a_wall() {
  ModelSource model =
      test::one_feature(test::feature("large", "cylinder", {{"radius", 10.0}, {"height", 10.0}}));
  FeatureSource small = test::feature("small", "cylinder", {{"radius", 4.0}, {"height", 6.0}});
  small.placement.origin = {6.01, 0.0, 2.0};
  model.features.push_back(small);
  return build_cells(evaluate(model), kRun).boundary;
}

TEST(FacetFaces, AFacetAcrossAStripBetweenTwoFacesOfNearlyTheSameNormalIsTheStrips) {
  const BoundaryModel boundary = strip_on_a_wall();
  // Two nodes on one of the lines that the strip shares with the large wall, one on the other.
  std::vector<Support> supports;
  std::vector<Vec3> nodes;
  int strip = -1;
  for (std::size_t e = 0; e < boundary.edges.size(); ++e) {
    const BoundaryEdge& edge = boundary.edges[e];
    if (edge.curve.kind != Curve::Kind::Line) continue;
    for (const double along : {0.3, 0.6}) {
      supports.push_back({Support::Kind::Edge, static_cast<std::int32_t>(e)});
      nodes.push_back(edge.points.front() + along * (edge.points.back() - edge.points.front()));
    }
    for (const int f : edge.faces)
      if (boundary.faces[f].surface.r1 == 4.0) strip = f;
  }
  ASSERT_EQ(nodes.size(), 4U);
  const FacetFaces faces(boundary, supports);
  EXPECT_EQ(faces.face_of({0, 1, 2}, nodes[0], nodes[1], nodes[2]), strip);
  EXPECT_EQ(faces.face_of({1, 2, 3}, nodes[1], nodes[2], nodes[3]), strip);
}

}  // namespace
}  // namespace remeshd
