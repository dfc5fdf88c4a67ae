#include "server/session/mesh_eviction.h"

#include <gmock/gmock.h>

namespace remeshd {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A chain `0`, `1`, ... of edits, all stored, 10 bytes each, the first used longest ago.
std::vector<StoredMesh> chain(int length) {
  std::vector<StoredMesh> meshes;
  for (int i = 0; i < length; ++i)
    meshes.push_back({.id = std::to_string(i),
                      .parent = i > 0 ? std::to_string(i - 1) : "",
                      .stored = true,
                      .has_recipe = true,
                      .used_ns = 100 + i,
                      .bytes = 10});
  return meshes;
}

TEST(MeshEviction, TakesThoseUsedLongestAgoUntilEnoughIsFreed) {
  EXPECT_THAT(meshes_to_drop(chain(5), 0), IsEmpty());
  EXPECT_THAT(meshes_to_drop(chain(5), 15), ElementsAre("0", "1"));
  auto meshes = chain(5);
  meshes[0].used_ns = 200;
  EXPECT_THAT(meshes_to_drop(meshes, 15), ElementsAre("1", "2"));
}

TEST(MeshEviction, LeavesAStoredOneAtMostEightEditsAway) {
  for (const bool last_first : {false, true}) {
    auto meshes = chain(40);
    if (last_first)
      for (auto& mesh : meshes) mesh.used_ns = 1000 - mesh.used_ns;
    for (const std::string& id : meshes_to_drop(meshes, 1000000))
      meshes[static_cast<std::size_t>(std::stoi(id))].stored = false;
    int stored = 0;
    for (const auto& mesh : meshes) stored += mesh.stored;
    EXPECT_LE(stored, 8);
    for (const int edits : edits_to_make(meshes)) EXPECT_LE(edits, 8);
  }
}

TEST(MeshEviction, CountsEveryBranchThatHasToBeMadeThroughAMesh) {
  // 0 .. 7 have gone, so 8 may not; `b` stands on 7 beside it.
  auto meshes = chain(9);
  for (int i = 0; i < 7; ++i) meshes[static_cast<std::size_t>(i)].stored = false;
  meshes.push_back({.id = "b", .parent = "7", .stored = false, .has_recipe = true});
  EXPECT_THAT(meshes_to_drop(meshes, 1000000), ElementsAre("8"));
}

TEST(MeshEviction, LeavesWhatIsPinnedOrCannotBeMadeAgain) {
  auto meshes = chain(4);
  meshes[0].pinned = true;
  meshes[1].has_recipe = false;
  EXPECT_THAT(meshes_to_drop(meshes, 1000000), ElementsAre("2", "3"));
  EXPECT_THAT(meshes_to_drop({{.id = "x", .parent = "unknown", .stored = true, .has_recipe = true}},
                             1000000),
              IsEmpty());
}

TEST(MeshEviction, TakesWhatWasNotUsedForLongThoughNothingHasToBeFreed) {
  EXPECT_THAT(meshes_to_drop(chain(5), 0, 102), ElementsAre("0", "1"));
}

TEST(MeshEviction, TellsHowManyEditsHaveToBeMade) {
  auto meshes = chain(4);
  meshes[1].stored = meshes[2].stored = false;
  EXPECT_THAT(edits_to_make(meshes), ElementsAre(0, 1, 2, 0));
  meshes[0].stored = false;
  EXPECT_THAT(edits_to_make(meshes), ElementsAre(1, 2, 3, 0));
}

TEST(MeshEviction, CopesWithAncestorsOfAsManyEditsAsAreMadeInWeeks) {
  auto meshes = chain(1'000'000);
  for (auto& mesh : meshes) mesh.stored = mesh.id == "999999";
  EXPECT_THAT(meshes_to_drop(meshes, 1000000), IsEmpty());
  const std::vector<int> edits = edits_to_make(meshes);
  EXPECT_EQ(edits[999'998], 999'999);
  EXPECT_EQ(edits[999'999], 0);
}

TEST(MeshEviction, EndsWhereAnAncestorIsItsOwn) {
  auto meshes = chain(3);
  meshes[0].parent = "2";
  for (auto& mesh : meshes) mesh.stored = false;
  for (const int edits : edits_to_make(meshes)) EXPECT_GT(edits, kMostRemade);
}

}  // namespace
}  // namespace remeshd
