#include "client/cli/report/correspondence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace remeshd::cli {
namespace {

using client::NodeOrigin;
using testing::ElementsAre;

/// Three tets in a row on five nodes; the edit moved the last node but one and put a new one at the
/// end.
ReportContent edited() {
  ReportContent content;
  content.base.emplace();
  client::Mesh& base = content.base->mesh;
  base.nodes.resize(6);
  base.tets = {{0, 1, 2, 3}, {1, 2, 3, 4}, {2, 3, 4, 5}};
  base.node_ids = {1, 2, 3, 4, 5, 6};
  base.tet_ids = {11, 12, 13};
  client::Mesh& mesh = content.modified.mesh;
  mesh = base;
  mesh.node_ids = {1, 2, 3, 4, 7, 8};
  mesh.tet_ids = {11, 14, 15};
  mesh.node_origin = {NodeOrigin::Kept, NodeOrigin::Kept,  NodeOrigin::Kept,
                      NodeOrigin::Kept, NodeOrigin::Moved, NodeOrigin::New};
  mesh.original_node = {0, 1, 2, 3, 4, -1};
  mesh.original_tet = {0, -1, -1};
  content.descent = Descent::Parent;
  return content;
}

TEST(Correspondence, OfAnEditIsReadFromItsMaps) {
  const Correspondence found = correspond(edited());
  EXPECT_THAT(found.modified, ElementsAre(TetState::Kept, TetState::Moved, TetState::New));
  EXPECT_THAT(found.base, ElementsAre(TetState::Kept, TetState::Gone, TetState::Gone));
  EXPECT_EQ(found.nodes.kept, 4U);
  EXPECT_EQ(found.nodes.moved, 1U);
  EXPECT_EQ(found.nodes.added, 1U);
  EXPECT_EQ(found.nodes.gone, 1U);
  EXPECT_EQ(found.tets.kept, 1U);
  EXPECT_EQ(found.tets.moved, 1U);
  EXPECT_EQ(found.tets.added, 1U);
  EXPECT_EQ(found.tets.gone, 2U);
}

TEST(Correspondence, OverSeveralEditsIsToldByPermanentIdsAndPlaces) {
  ReportContent content = edited();
  content.descent = Descent::Ancestor;
  client::Mesh& mesh = content.modified.mesh;
  mesh.original_tet = {2, 2, 2};  // of the parent, which is another mesh
  mesh.original_node = {5, 5, 5, 5, 5, 5};
  mesh.node_origin.assign(6, NodeOrigin::Kept);
  mesh.node_ids = {1, 2, 3, 4, 5, 8};
  mesh.nodes[4] = {0, 0, 1};
  const Correspondence found = correspond(content);
  EXPECT_THAT(found.modified, ElementsAre(TetState::Kept, TetState::Moved, TetState::New));
  EXPECT_THAT(found.base, ElementsAre(TetState::Kept, TetState::Gone, TetState::Gone));
  EXPECT_EQ(found.nodes.kept, 4U);
  EXPECT_EQ(found.nodes.moved, 1U);
  EXPECT_EQ(found.nodes.added, 1U);
  EXPECT_EQ(found.nodes.gone, 1U);
}

TEST(Correspondence, OfMeshesOfDifferentChainsIsNone) {
  ReportContent content = edited();
  content.descent = Descent::None;
  const Correspondence found = correspond(content);
  EXPECT_EQ(found.tets.kept, 0U);
  EXPECT_EQ(found.tets.added, 3U);
  EXPECT_EQ(found.tets.gone, 3U);
  EXPECT_EQ(found.nodes.gone, 6U);
}

TEST(Correspondence, OfAFirstMeshHasNothingGone) {
  ReportContent content = edited();
  content.base.reset();
  const Correspondence found = correspond(content);
  EXPECT_THAT(found.base, ElementsAre());
  EXPECT_EQ(found.tets.added, 3U);
  EXPECT_EQ(found.nodes.added, 6U);
  EXPECT_EQ(found.nodes.gone, 0U);
}

}  // namespace
}  // namespace remeshd::cli
