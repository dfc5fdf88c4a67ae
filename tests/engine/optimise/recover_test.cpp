#include "engine/optimise/recover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

#include "tests/support/run.h"
#include "tests/support/solid_fixture.h"

namespace remeshd {
namespace {

using test::kRun;

/// A cylinder of radius 10, its boundary alone.
class Circles : public testing::Test {
 protected:
  std::ptrdiff_t nodes_on(int edge) const {
    return std::ranges::count(nodes_.supports, Support{Support::Kind::Edge, edge});
  }
  void recover() {
    Box bounds;
    bounds.add(boundary_.bounds.lo);
    bounds.add(boundary_.bounds.hi);
    LiveMesh live(DelaunayMesh(bounds), std::vector<std::uint8_t>(nodes_.size(), 0), false, kRun);
    recover_edges(nodes_, boundary_, live, {.sizes = 20});
  }

  const BoundaryModel boundary_ = test::make_cylinder(10, 8, 12, 1).boundary;
  NodeSet nodes_;
};

TEST_F(Circles, GetThreeNodesWhereTheyHaveNone) {
  nodes_.add_new({0, 0, 4});
  recover();
  EXPECT_GE(nodes_on(0), 3);
  EXPECT_GE(nodes_on(1), 3);
}

TEST_F(Circles, GetAThirdNodeWhereTheyHaveTwo) {
  for (const double z : {0.0, 8.0})
    for (const double x : {10.0, -10.0}) nodes_.add_new({x, 0, z}, {Support::Kind::Edge, z > 4});
  // Beside the two, so that the straight line between them is an edge of the mesh.
  for (const double y : {3.0, -3.0}) nodes_.add_new({0, y, 4});
  recover();
  EXPECT_GE(nodes_on(0), 3);
  EXPECT_GE(nodes_on(1), 3);
}

}  // namespace
}  // namespace remeshd
