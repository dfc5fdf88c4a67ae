#include "engine/mesh/unchanged.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "engine/base/random.h"

namespace remeshd {
namespace {

constexpr std::int32_t kNodes = 1000, kTets = 1500;
constexpr auto kPage = static_cast<std::int32_t>(CowVector<Tet>::kPage);

/// Tets between nodes that are near in number and in space; whether they are positive is not asked.
PagedMesh some_mesh() {
  Random random(1);
  TetMesh mesh;
  for (std::int32_t n = 0; n < kNodes; ++n)
    mesh.nodes.push_back({random.uniform() + 0.05 * n, random.uniform(), random.uniform()});
  for (std::int32_t t = 0; t < kTets; ++t) {
    const std::int32_t n = t * (kNodes - 4) / kTets;
    mesh.tets.push_back({n, n + 1, n + 2, n + 3});
  }
  return paged(mesh);
}

/// By comparing everything.
std::set<std::int32_t> changed_tets(const PagedMesh& mesh, const PagedMesh& other) {
  std::set<std::int32_t> changed;
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(mesh.tets.size()); ++t) {
    bool same = static_cast<std::size_t>(t) < other.tets.size() && mesh.tets[t] == other.tets[t];
    for (const std::int32_t n : mesh.tets[t])
      same = same && static_cast<std::size_t>(n) < other.nodes.size() &&
             mesh.nodes[n] == other.nodes[n];
    if (!same) changed.insert(t);
  }
  return changed;
}

TEST(Unchanged, IsWhatComparingEverythingSays) {
  const PagedMesh other = some_mesh();
  using Change = std::function<void(PagedMesh&)>;
  const std::vector<Change> changes{
      [](PagedMesh&) {},
      [](PagedMesh& m) { m.nodes.edit(500).x += 1; },
      [](PagedMesh& m) { m.tets.edit(2 * kPage)[1] = 7; },
      [](PagedMesh& m) { m.tets.edit(3)[0] = m.tets[3][0]; },  // other memory, the same in it
      [](PagedMesh& m) { m.tets.resize(kTets - 1); },
      [](PagedMesh& m) { m.tets.resize(kPage); },
      [](PagedMesh& m) {
        m.tets.resize(kTets + 3, {0, 1, 2, 3});
      },
      [](PagedMesh& m) {
        m.tets.resize(3 * kTets, {0, 1, 2, 3});
      },
      [](PagedMesh& m) {
        m.nodes.resize(kNodes + 1, {1, 2, 3});
        m.tets.edit(9)[2] = kNodes;
      },
      [](PagedMesh& m) {
        m.nodes = CowVector(m.nodes.flat());
        m.tets = CowVector(m.tets.flat());
      }};
  for (std::size_t k = 0; k < changes.size(); ++k) {
    SCOPED_TRACE(k);
    PagedMesh mesh = other;
    changes[k](mesh);
    const Unchanged result = unchanged(mesh, other, boxes_round(other));
    const std::set<std::int32_t> expected = changed_tets(mesh, other);
    EXPECT_TRUE(std::ranges::equal(result.changed_tets, expected));
    ASSERT_EQ(result.node.size(), mesh.nodes.size());
    for (std::size_t n = 0; n < result.node.size(); ++n)
      EXPECT_EQ(result.node[n] != 0, n < other.nodes.size() && mesh.nodes[n] == other.nodes[n]);
    ASSERT_EQ(result.page.size(), mesh.tets.pages());
    for (std::size_t page = 0; page < result.page.size(); ++page) {
      const auto first = static_cast<std::int32_t>(page * kPage);
      const bool none = expected.lower_bound(first) == expected.lower_bound(first + kPage);
      const bool as_many =
          page < other.tets.pages() && mesh.tets.page(page).size() == other.tets.page(page).size();
      EXPECT_EQ(result.page[page] != 0, none && as_many);
    }
  }
}

TEST(TetBoxes, AreMeasuredAgainWhereTetsChanged) {
  const PagedMesh other = some_mesh();
  const CowVector<Box> boxes = boxes_round(other);
  PagedMesh mesh = other;
  mesh.nodes.edit(700).z += 3;
  mesh.tets.edit(9)[1] = 500;
  mesh.tets.resize(2 * kTets, {0, 1, 2, 3});
  const std::vector<std::int32_t> changed = unchanged(mesh, other, boxes).changed_tets;
  const CowVector<Box> again = boxes_round(mesh, boxes, changed);
  const CowVector<Box> expected = boxes_round(mesh);
  ASSERT_EQ(again.size(), expected.size());
  for (std::size_t k = 0; k < again.size(); ++k) {
    EXPECT_EQ(again[k].lo, expected[k].lo);
    EXPECT_EQ(again[k].hi, expected[k].hi);
  }
}

TEST(PagesNear, MissNoneWithANodeThere) {
  const PagedMesh other = some_mesh();
  const CowVector<Box> boxes = boxes_round(other);
  PagedMesh mesh = other;
  mesh.tets.edit(3 * kPage)[0] = 1;
  std::size_t missed = 0;
  for (const std::int32_t n : {0, 123, 500, kNodes - 1}) {
    const std::vector<Vec3> places{other.nodes[n]};
    const PagesNear at(other.tets, boxes, places);
    EXPECT_TRUE(at.may_be(mesh.tets, 3)) << "it is another page";
    for (std::size_t k = 0; k < other.tets.pages(); ++k) {
      const bool there = std::ranges::any_of(
          other.tets.page(k), [&](const Tet& t) { return std::ranges::find(t, n) != t.end(); });
      if (there) {
        EXPECT_TRUE(at.may_be(mesh.tets, k));
      }
      missed += at.may_be(mesh.tets, k) ? 0 : 1;
    }
  }
  EXPECT_GT(missed, 8U);
}

}  // namespace
}  // namespace remeshd
