#include "engine/remesh/finish/stranded_nodes.h"

#include <gtest/gtest.h>

#include "tests/support/boundary_faces.h"

namespace remeshd {
namespace {

/// Face 0 at z = 0, 10 by 10, with a node on it.
class NodesOfTheInside : public testing::Test {
 protected:
  NodesOfTheInside() {
    boundary_.faces = {test::square_face(0, 0, true)};
    add({2.5, 2, 0}, {Support::Kind::Face, 0});
  }
  std::int32_t add(const Vec3& p, const Support& support) {
    nodes_.add_new(p, support);
    return nodes_.size() - 1;
  }
  int support_near(const Vec3& place) {
    const MeshDefect defect{MeshFailure::NonconformingFacet, 0, place, "on no face"};
    return support_stranded_nodes(nodes_, {&defect, 1}, boundary_, SizeField(2));
  }

  BoundaryModel boundary_;
  NodeSet nodes_;
};

TEST_F(NodesOfTheInside, ThatStandOnAFaceBecomeNodesOfIt) {
  const std::int32_t on = add({2, 2, 0}, {}), below = add({2, 3, -1e-3}, {});
  EXPECT_EQ(support_near({2, 2, 0}), 1);
  EXPECT_EQ(nodes_.supports[on], (Support{Support::Kind::Face, 0}));
  EXPECT_EQ(nodes_.supports[below], Support{});
  EXPECT_EQ(support_near({2, 2, 0}), 0);
}

TEST_F(NodesOfTheInside, AreLeftFarFromDefects) {
  add({2, 2, 0}, {});
  EXPECT_EQ(support_near({6, 6, 0}), 0);
}

TEST_F(NodesOfTheInside, AreLeftWhereTheFaceDoesNotReach) {
  add({2, -1, 0}, {});
  add({2, 0, 0}, {Support::Kind::Face, 0});
  EXPECT_EQ(support_near({2, -1, 0}), 0);
}

TEST_F(NodesOfTheInside, AreLeftAtTheInterfaceOfAPatch) {
  add({2, 2, 0}, {});
  nodes_.interface_nodes = nodes_.size();
  EXPECT_EQ(support_near({2, 2, 0}), 0);
}

}  // namespace
}  // namespace remeshd
