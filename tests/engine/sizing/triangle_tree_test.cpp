#include "engine/sizing/triangle_tree.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/random.h"
#include "engine/cellular/boundary_model/face_distance.h"
#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

double nearest_by_all(const BoundaryModel& boundary, const Vec3& p, double within,
                      const std::vector<std::uint8_t>& left_out) {
  double least = within;
  for (std::size_t f = 0; f < boundary.faces.size(); ++f)
    if (left_out[f] == 0) least = std::fmin(least, std::sqrt(face_distance2(boundary.faces[f], p)));
  return least;
}

TEST(TriangleTree, FindsWhatIsNearestOfTheFacesThatAreNotLeftOut) {
  const BoundaryModel boundary = build_cells(test::case_features("tool1-a"), kRun).boundary;
  const TriangleTree tree(boundary);
  const Vec3 sides = boundary.bounds.hi - boundary.bounds.lo;
  Random random(1);
  const auto along = [&](double side) { return random.uniform(-0.2, 1.2) * side; };
  std::vector<std::uint8_t> left_out(boundary.faces.size());
  for (int k = 0; k < 300; ++k) {
    for (std::uint8_t& left : left_out) left = random.uniform(0, 1) < 0.3 ? 1 : 0;
    const Vec3 p = boundary.bounds.lo + Vec3{along(sides.x), along(sides.y), along(sides.z)};
    const double within = random.uniform(0, 0.3) * boundary.bounds.diagonal();
    const double wanted = nearest_by_all(boundary, p, within, left_out);
    const TriangleTree::Nearest nearest = tree.nearest(p, within, left_out);
    EXPECT_NEAR(nearest.distance, wanted, 1e-12 * boundary.bounds.diagonal());
    EXPECT_EQ(nearest.found, wanted < within);
    EXPECT_NEAR(nearest.found ? distance(p, nearest.at) : nearest.distance, nearest.distance, 1e-9);
  }
}

TEST(TriangleTree, FindsNothingWhereAllIsLeftOutOrThereIsNothing) {
  const BoundaryModel boundary = build_cells(test::case_features("simple-a"), kRun).boundary;
  const std::vector<std::uint8_t> all(boundary.faces.size(), 1);
  EXPECT_FALSE(TriangleTree(boundary).nearest({0, 0, 0}, 1e6, all).found);
  const TriangleTree::Nearest none = TriangleTree(BoundaryModel{}).nearest({0, 0, 0}, 2, {});
  EXPECT_FALSE(none.found);
  EXPECT_EQ(none.distance, 2);
}

}  // namespace
}  // namespace remeshd
