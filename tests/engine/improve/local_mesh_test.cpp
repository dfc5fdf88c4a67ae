#include "engine/improve/local_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace remeshd {
namespace {

/// Two tets on the facet 0-1-2, and the three round the edge 3-4 that fill the same room.
const TetMesh kTwo{{{1, 0, 0}, {-0.5, 0.8, 0}, {-0.5, -0.8, 0}, {0, 0, 1}, {0, 0, -1}},
                   {{0, 1, 2, 3}, {0, 2, 1, 4}}};
const std::vector<Tet> kThree{{4, 3, 0, 1}, {4, 3, 1, 2}, {4, 3, 2, 0}};

std::vector<std::int32_t> tets_of(const LocalMesh& mesh, std::int32_t node) {
  std::vector<std::int32_t> tets(mesh.tets_of(node).begin(), mesh.tets_of(node).end());
  std::sort(tets.begin(), tets.end());
  return tets;
}

void expect_as_at_the_start(const LocalMesh& mesh) {
  EXPECT_EQ(mesh.slots(), 2);
  EXPECT_EQ(mesh.result().tets, kTwo.tets);
  EXPECT_EQ(mesh.result().nodes, kTwo.nodes);
  for (std::int32_t n = 0; n < 5; ++n)
    EXPECT_EQ(tets_of(mesh, n), tets_of(LocalMesh(kTwo), n)) << "node " << n;
}

TEST(LocalMesh, TakesBackTheMovesAndReplacementsOfATrialInTheirSlots) {
  LocalMesh mesh(kTwo);
  const double quality = mesh.quality(0);
  mesh.begin_trial();
  mesh.move(3, {0, 0, 2});
  std::vector<std::int32_t> slots;
  mesh.replace(std::vector{0, 1}, kThree, slots);
  mesh.move(3, {0, 0, 3});
  EXPECT_NE(mesh.stamp(0), 0U);
  const std::vector<std::int32_t> three = slots;
  slots.clear();
  mesh.replace(three, kTwo.tets, slots);
  mesh.undo_trial();
  expect_as_at_the_start(mesh);
  EXPECT_EQ(mesh.quality(0), quality) << "of the tet that stands there again";
  for (const std::int32_t t : {0, 1}) EXPECT_EQ(mesh.stamp(t), 0U) << "tet " << t;
}

TEST(LocalMesh, GivesTheSameSlotsAfterATrialTakenBackAsWithoutIt) {
  LocalMesh tried(kTwo), plain(kTwo);
  std::vector<std::int32_t> slots;
  tried.begin_trial();
  tried.replace(std::vector{1, 0}, kThree, slots);
  tried.undo_trial();
  std::vector<std::int32_t> tried_slots, plain_slots;
  tried.replace(std::vector{0, 1}, kThree, tried_slots);
  plain.replace(std::vector{0, 1}, kThree, plain_slots);
  EXPECT_EQ(tried_slots, plain_slots);
  EXPECT_EQ(tried.result().tets, plain.result().tets);
}

TEST(LocalMesh, KeepsWhatATrialChangedAndTakesBackOnlyTheNext) {
  LocalMesh mesh(kTwo);
  mesh.begin_trial();
  mesh.move(3, {0, 0, 2});
  mesh.keep_trial();
  mesh.begin_trial();
  mesh.move(4, {0, 0, -2});
  mesh.undo_trial();
  EXPECT_EQ(mesh.node(3), Vec3(0, 0, 2));
  EXPECT_EQ(mesh.node(4), kTwo.nodes[4]);
}

}  // namespace
}  // namespace remeshd
