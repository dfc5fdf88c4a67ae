#include "engine/delaunay/paged_delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "engine/mesh/tet_mesh.h"
#include "tests/engine/delaunay/clouds.h"

namespace remeshd {
namespace {

using namespace test;

PagedDelaunay paged(const std::vector<Vec3>& points) {
  std::vector<std::int32_t> to;
  return {mesh_of(points), to};
}

/// The whole as a patch of itself.
DelaunayMesh unpaged(const PagedDelaunay& mesh) {
  std::vector<std::int32_t> slots;
  for (std::int32_t s = 0; s < static_cast<std::int32_t>(mesh.slots()); ++s)
    if (mesh.in_use(s)) slots.push_back(s);
  PagedDelaunay::Cut cut;
  return mesh.cut(slots, all(mesh.positions().size()),
                  static_cast<std::int32_t>(mesh.positions().size()), cut);
}

/// How many of the pages of its tets a mesh has in common with another.
std::size_t pages_shared(const PagedDelaunay& a, const PagedDelaunay& b) {
  std::size_t shared = 0;
  a.visit_arrays([&](const auto&, const auto& slots, const auto&, const auto&) {
    b.visit_arrays([&](const auto&, const auto& others, const auto&, const auto&) {
      for (std::size_t k = 0; k < slots.pages(); ++k) shared += slots.shares(k, others) ? 1 : 0;
    });
  });
  return shared;
}

/// A mesh's tets stand in another at the slots `to`.
template <class Mesh>
void expect_moved(const Mesh& mesh, const PagedDelaunay& other,
                  const std::vector<std::int32_t>& to) {
  ASSERT_EQ(to.size(), mesh.slots());
  for (std::size_t s = 0; s < to.size(); ++s) {
    const auto slot = static_cast<std::int32_t>(s);
    ASSERT_EQ(to[s] >= 0, mesh.in_use(slot));
    if (to[s] >= 0) {
      EXPECT_EQ(other.corners(to[s]), mesh.corners(slot));
    }
  }
}

TEST(PagedDelaunay, HasTheTetsInTheOrderOfTheirLowestNodes) {
  const auto points = cloud(400, 9);
  DelaunayMesh mesh = mesh_of(points);
  std::vector<std::int32_t> some(150);
  std::iota(some.begin(), some.end(), 100);
  ASSERT_TRUE(mesh.remove(some, kRun));
  ASSERT_LT(mesh.size(), mesh.slots());
  std::vector<std::int32_t> to;
  const PagedDelaunay at_rest(mesh, to);
  EXPECT_EQ(at_rest.slots(), mesh.size());
  expect_moved(mesh, at_rest, to);
  const auto lowest = [&](std::int32_t slot) {
    std::uint32_t low = ~0U;
    for (const std::int32_t n : at_rest.corners(slot))
      low = std::min(low, static_cast<std::uint32_t>(n < 0 ? 1000 : n));
    return low;
  };
  for (std::int32_t s = 1; s < static_cast<std::int32_t>(at_rest.slots()); ++s)
    EXPECT_LE(lowest(s - 1), lowest(s));
  DelaunayMesh again = unpaged(at_rest);
  again.insert(points, some, kRun);
  EXPECT_EQ(sorted_tets(again), sorted_tets(mesh_of(points)));
}

TEST(PagedDelaunay, WithoutGapsItIsTheSameMesh) {
  const auto points = cloud(2000, 4);
  PagedDelaunay mesh = paged(points);
  std::vector<std::int32_t> slots;
  for (std::int32_t s = 0; s < static_cast<std::int32_t>(mesh.slots()); ++s) slots.push_back(s);
  PagedDelaunay::Cut cut;
  DelaunayMesh patch = mesh.cut(slots, all(2000), 2000, cut);
  std::vector<std::int32_t> some(500), names = all(2000);
  std::iota(some.begin(), some.end(), 1500);
  ASSERT_TRUE(patch.remove(some, kRun));
  std::fill(names.begin() + 1500, names.end(), -1);
  mesh.put_back(patch, cut, names, 1500);
  ASSERT_LT(mesh.size(), mesh.slots());
  PagedDelaunay tight = mesh;
  const std::vector<std::int32_t> to = tight.close_gaps();
  EXPECT_EQ(tight.slots(), mesh.size());
  EXPECT_EQ(tight.size(), mesh.size());
  expect_moved(mesh, tight, to);
  EXPECT_EQ(sorted_tets(unpaged(tight)),
            sorted_tets(mesh_of({points.begin(), points.begin() + 1500})));
}

TEST(PagedDelaunay, AllOfItMadeAnewOfFewerTetsIsPutBack) {
  const auto points = cloud(2000, 4);
  PagedDelaunay mesh = paged(points);
  std::vector<std::int32_t> slots(mesh.slots()), names = all(2000);
  std::iota(slots.begin(), slots.end(), 0);
  PagedDelaunay::Cut cut;
  DelaunayMesh patch = mesh.cut(slots, names, 2000, cut).emptied();
  patch.insert(points, all(500), kRun);
  ASSERT_LT(patch.slots(), slots.size());
  std::fill(names.begin() + 500, names.end(), -1);
  const std::vector<std::int32_t> place = mesh.put_back(patch, cut, names, 500);
  ASSERT_EQ(place.size(), slots.size());
  EXPECT_EQ(std::ranges::count(place, -1),
            static_cast<std::ptrdiff_t>(slots.size() - patch.size()));
  EXPECT_EQ(sorted_tets(unpaged(mesh)),
            sorted_tets(mesh_of({points.begin(), points.begin() + 500})));
}

TEST(PagedDelaunay, AllOfItMadeAnewInLargerBoundsEnclosesThem) {
  std::vector<Vec3> points = cloud(300, 4);
  PagedDelaunay mesh = paged(points);
  std::vector<std::int32_t> slots(mesh.slots());
  std::iota(slots.begin(), slots.end(), 0);
  PagedDelaunay::Cut cut;
  (void)mesh.cut(slots, all(300), 300, cut);
  points.front() = {200, 0, 0};
  Box larger = unit_box();
  larger.add(points.front());
  DelaunayMesh patch(larger);
  patch.insert(points, all(300), kRun);
  ASSERT_FALSE(mesh_of(cloud(300, 4)).encloses(larger));
  mesh.put_back(patch, cut, all(300), 300);
  EXPECT_TRUE(mesh.consistent());
  EXPECT_TRUE(unpaged(mesh).encloses(larger));
}

/// The tets at nodes within a ball, cut out of a mesh of a cloud.
struct Part {
  std::vector<Vec3> points = cloud(3000, 5);
  PagedDelaunay whole = paged(points);
  std::vector<std::int32_t> inner;  ///< nodes of the whole
  std::vector<std::int32_t> names;  ///< by node of the whole: that of the patch, or -1
  std::vector<std::int32_t> nodes;  ///< by node of the patch: that of the whole
  PagedDelaunay::Cut cut;
  DelaunayMesh patch;

  Part() : names(points.size(), -1) {
    const auto near = [&](std::int32_t n) {
      return n >= 0 && distance(points[n], {0.5, 0.5, 0.5}) < 0.3;
    };
    std::vector<std::int32_t> slots;
    for (std::int32_t s = 0; s < static_cast<std::int32_t>(whole.slots()); ++s) {
      if (!whole.in_use(s) || std::ranges::none_of(whole.corners(s), near)) continue;
      slots.push_back(s);
      for (const std::int32_t n : whole.corners(s)) {
        if (n < 0 || names[n] >= 0) continue;
        names[n] = static_cast<std::int32_t>(nodes.size());
        nodes.push_back(n);
        if (near(n)) inner.push_back(n);
      }
    }
    patch = whole.cut(slots, names, static_cast<std::int32_t>(nodes.size()), cut);
  }

  /// Moves inner nodes within a ball round the middle by up to `step`, in the cloud.
  std::vector<std::int32_t> stir(double radius, double step) {
    Random random(7);
    std::vector<std::int32_t> moved;
    for (const std::int32_t n : inner) {
      if (distance(points[n], {0.5, 0.5, 0.5}) > radius) continue;
      points[n] += step * Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
      moved.push_back(names[n]);
    }
    return moved;
  }
  [[nodiscard]] std::vector<Vec3> places() const {
    std::vector<Vec3> places;
    for (const std::int32_t n : nodes) places.push_back(points[n]);
    return places;
  }
};

TEST(PagedDelaunay, WithAPartPutBackIsTheMeshOfAllNodes) {
  Part p;
  const auto moved = p.stir(0.12, 0.05);
  ASSERT_GT(moved.size(), 15U);
  if (p.patch.move(p.places(), moved, kRun) == DelaunayMesh::Moved::TooFar) {
    ASSERT_TRUE(p.patch.reinsert(p.places(), moved, kRun));
  }
  ASSERT_FALSE(p.patch.patch_too_small());
  p.whole.put_back(p.patch, p.cut, p.nodes, static_cast<std::int32_t>(p.points.size()));
  EXPECT_EQ(sorted_tets(unpaged(p.whole)), sorted_tets(mesh_of(p.points)));
}

TEST(PagedDelaunay, CanBeChangedAgainAfterAPartWasPutBack) {
  Part p;
  const auto moved = p.stir(0.12, 0.02);
  ASSERT_NE(p.patch.move(p.places(), moved, kRun), DelaunayMesh::Moved::Failed);
  p.whole.put_back(p.patch, p.cut, p.nodes, static_cast<std::int32_t>(p.points.size()));
  p.stir(0.3, 0.02);
  DelaunayMesh again = unpaged(p.whole);
  follow(again, p.points);
  EXPECT_EQ(sorted_tets(again), sorted_tets(mesh_of(p.points)));
}

TEST(PagedDelaunay, NodesAtTheBorderOfAPartCannotBeRemoved) {
  Part p;
  const std::vector<Tet> before = sorted_tets(p.patch);
  int at_border = 0;
  for (std::int32_t n = 0; n < static_cast<std::int32_t>(p.nodes.size()); ++n) {
    if (std::ranges::find(p.inner, p.nodes[n]) != p.inner.end()) continue;
    ++at_border;
    ASSERT_FALSE(p.patch.remove(std::vector{n}, kRun)) << n;
  }
  EXPECT_GT(at_border, 100);
  EXPECT_EQ(sorted_tets(p.patch), before);
}

TEST(PagedDelaunay, TakesNewNodesOfAPartAndGivesSomeUp) {
  Part p;
  std::vector<Vec3> places = p.places();
  std::int32_t middle = -1;  // the node nearest to the middle goes
  for (const std::int32_t n : p.inner)
    if (middle < 0 ||
        distance(p.points[n], {0.5, 0.5, 0.5}) < distance(p.points[middle], {0.5, 0.5, 0.5}))
      middle = n;
  ASSERT_TRUE(p.patch.remove(std::vector{p.names[middle]}, kRun));
  places.push_back({0.52, 0.5, 0.51});
  places.push_back({0.48, 0.47, 0.5});
  const auto count = static_cast<std::int32_t>(p.nodes.size());
  p.patch.insert(places, std::vector{count, count + 1}, kRun);
  ASSERT_FALSE(p.patch.patch_too_small());
  // One takes the place of the node that went, the other comes last.
  p.nodes.push_back(middle);
  p.nodes.push_back(static_cast<std::int32_t>(p.points.size()));
  p.nodes[p.names[middle]] = -1;
  p.points[middle] = places[count];
  p.points.push_back(places[count + 1]);
  p.whole.put_back(p.patch, p.cut, p.nodes, static_cast<std::int32_t>(p.points.size()));
  EXPECT_EQ(sorted_tets(unpaged(p.whole)), sorted_tets(mesh_of(p.points)));
}

TEST(PagedDelaunay, ItsPartTellsWhereAChangeGoesBeyondTheRim) {
  Part p;
  std::vector<Vec3> places = p.places();
  places.push_back({0.5, 0.5, 0.95});
  p.patch.insert(places, std::vector{static_cast<std::int32_t>(p.nodes.size())}, kRun);
  EXPECT_TRUE(p.patch.patch_too_small());
  Part q;
  const auto moved = q.stir(0.3, 0.1);
  if (q.patch.move(q.places(), moved, kRun) == DelaunayMesh::Moved::TooFar) {
    ASSERT_TRUE(q.patch.reinsert(q.places(), moved, kRun));
  }
  EXPECT_TRUE(q.patch.patch_too_small());
}

TEST(PagedDelaunay, SharesWhatDidNotChange) {
  Part p;
  const PagedDelaunay before = p.whole;
  p.whole.put_back(p.patch, p.cut, p.nodes, static_cast<std::int32_t>(p.points.size()));
  EXPECT_EQ(pages_shared(before, p.whole), pages_shared(before, before)) << "nothing changed";
  const auto moved = p.stir(0.12, 0.02);
  ASSERT_NE(p.patch.move(p.places(), moved, kRun), DelaunayMesh::Moved::Failed);
  p.whole.put_back(p.patch, p.cut, p.nodes, static_cast<std::int32_t>(p.points.size()));
  const std::size_t shared = pages_shared(before, p.whole), pages = pages_shared(before, before);
  EXPECT_LT(shared, pages);
  EXPECT_GT(shared, 0U);
  EXPECT_EQ(sorted_tets(unpaged(before)), sorted_tets(mesh_of(cloud(3000, 5))))
      << "the one it was made of is as it was";
}

/// Tets that a walk over the pages near a box finds, and those of them with a node there.
void expect_all_tets_near(const PagedDelaunay& mesh, const Box& box) {
  const auto meets = [&](const Box& page) { return !intersection(page, box).empty(); };
  std::vector<int> seen(mesh.slots(), 0);
  mesh.for_each_slot_near(meets, [&](std::int32_t s) { seen[s] = 1; });
  const std::size_t near = std::ranges::count(seen, 1);
  std::size_t there = 0;
  for (std::int32_t s = 0; s < static_cast<std::int32_t>(mesh.slots()); ++s) {
    if (!mesh.in_use(s)) continue;
    if (std::ranges::none_of(mesh.corners(s), [&](std::int32_t n) {
          return n >= 0 && box.contains(mesh.positions()[n]);
        }))
      continue;
    ++there;
    EXPECT_EQ(seen[s], 1);
  }
  EXPECT_GT(there, 0U);
  EXPECT_LT(near, mesh.size());
}

TEST(PagedDelaunay, FindsTheTetsNearABox) {
  Box box = unit_box();
  box.hi = {0.3, 0.25, 0.2};
  std::vector<Vec3> points = cloud(3000, 5);
  std::ranges::sort(points, {}, [](const Vec3& p) { return p.x; });  // pages have their places
  expect_all_tets_near(paged(points), box);
  Part p;
  const auto moved = p.stir(0.12, 0.05);
  if (p.patch.move(p.places(), moved, kRun) == DelaunayMesh::Moved::TooFar) {
    ASSERT_TRUE(p.patch.reinsert(p.places(), moved, kRun));
  }
  ASSERT_FALSE(p.patch.patch_too_small());
  p.whole.put_back(p.patch, p.cut, p.nodes, static_cast<std::int32_t>(p.points.size()));
  // Tets of random nodes stand anywhere in memory; all that matters is that none is missed.
  const auto everywhere = [](const Box&) { return true; };
  std::size_t count = 0;
  p.whole.for_each_slot_near(everywhere, [&](std::int32_t) { ++count; });
  EXPECT_EQ(count, p.whole.size());
  for (std::int32_t s = 0; s < static_cast<std::int32_t>(p.whole.slots()); ++s) {
    if (!p.whole.in_use(s)) continue;
    for (const std::int32_t n : p.whole.corners(s)) {
      if (n < 0) continue;
      const Vec3& at = p.whole.positions()[n];
      bool found = false;
      p.whole.for_each_slot_near([&](const Box& page) { return page.contains(at); },
                                 [&](std::int32_t t) { found = found || t == s; });
      ASSERT_TRUE(found);
    }
    if (s > 300) break;
  }
}

TEST(PagedDelaunay, RenamesItsLastNodes) {
  const auto points = cloud(300, 6);
  PagedDelaunay mesh = paged(points);
  std::vector<std::int32_t> slots;
  for (std::int32_t s = 0; s < static_cast<std::int32_t>(mesh.slots()); ++s) slots.push_back(s);
  PagedDelaunay::Cut cut;
  DelaunayMesh patch = mesh.cut(slots, all(300), 300, cut);
  ASSERT_TRUE(patch.remove(std::array{7, 100, 298}, kRun));
  std::vector<std::int32_t> names = all(300);
  names[7] = names[100] = names[298] = -1;
  mesh.put_back(patch, cut, names, 300);
  mesh.rename_last(std::array{7, -1, 100}, 297);
  std::vector<Vec3> renamed(points.begin(), points.begin() + 297);
  renamed[7] = points[297];
  renamed[100] = points[299];
  EXPECT_EQ(mesh.positions(), CowVector<Vec3>(renamed));
  EXPECT_EQ(sorted_tets(unpaged(mesh)), sorted_tets(mesh_of(renamed)));
}

}  // namespace
}  // namespace remeshd
