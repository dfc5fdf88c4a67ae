#include "engine/delaunay/delaunay_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "engine/base/random.h"
#include "engine/kernel/predicates.h"
#include "engine/mesh/quality.h"
#include "engine/mesh/tet_mesh.h"
#include "tests/engine/delaunay/clouds.h"

namespace remeshd {
namespace {

using namespace test;

/// Every node outside every circumsphere, every tet positive.
void expect_delaunay(const DelaunayMesh& mesh, const std::vector<Vec3>& p,
                     const std::vector<std::int32_t>& nodes) {
  int count = 0, bad = 0;
  mesh.for_each_tet([&](const Tet& t) {
    ++count;
    ASSERT_GT(kernel::orientation(p[t[0]], p[t[1]], p[t[2]], p[t[3]]), 0);
    for (const std::int32_t n : nodes)
      if (std::find(t.begin(), t.end(), n) == t.end())
        bad += kernel::in_sphere(p[t[0]], p[t[1]], p[t[2]], p[t[3]], p[n]) > 0;
  });
  EXPECT_GT(count, 0);
  EXPECT_EQ(bad, 0);
}

TEST(Delaunay, NoNodeLiesInACircumsphere) {
  const auto points = cloud(300, 1);
  expect_delaunay(mesh_of(points), points, all(300));
}

TEST(Delaunay, TheMeshOfACubesCornersFillsTheCube) {
  std::vector<Vec3> points;  // eight cospherical nodes, and coplanar ones on every side
  for (const double x : {0.0, 0.5, 1.0})
    for (const double y : {0.0, 0.5, 1.0})
      for (const double z : {0.0, 0.5, 1.0}) points.push_back({z, y, x});
  double volume = 0;
  mesh_of(points).for_each_tet([&](const Tet& t) {
    volume += tet_volume(points[t[0]], points[t[1]], points[t[2]], points[t[3]]);
  });
  EXPECT_NEAR(volume, 1, 1e-12);
}

TEST(Delaunay, TheOrderOfInsertionDoesNotMatter) {
  const auto points = cloud(400, 2);
  auto backwards = all(400);
  std::reverse(backwards.begin(), backwards.end());
  DelaunayMesh mesh(unit_box());
  mesh.insert(points, {backwards.data(), 150}, kRun);
  mesh.insert(points, {backwards.data() + 150, 250}, kRun);
  EXPECT_EQ(sorted_tets(mesh), sorted_tets(mesh_of(points)));
}

/// Tets that are said to share a facet do.
void expect_neighbours(const DelaunayMesh& mesh) {
  std::vector<Tet> tets(mesh.slots(), Tet{-1, -1, -1, -1});
  mesh.for_each_tet_with_neighbours(
      [&](std::int32_t slot, const Tet& t, const Tet&) { tets[slot] = t; });
  mesh.for_each_tet_with_neighbours([&](std::int32_t, const Tet& t, const Tet& across) {
    for (int i = 0; i < 4; ++i) {
      if (across[i] < 0 || tets[across[i]][0] < 0) continue;  // at a super vertex
      for (const int k : kTetFacets[i])
        EXPECT_NE(std::ranges::find(tets[across[i]], t[k]), tets[across[i]].end());
      EXPECT_EQ(std::ranges::find(tets[across[i]], t[i]), tets[across[i]].end());
    }
  });
}

TEST(Delaunay, ANodeThatManyOthersSurroundIsLinkedWithAllOfThem) {
  for (const int count : {12, 63, 64, 65, 66, 400}) {
    SCOPED_TRACE(count);
    std::vector<Vec3> points = cloud(count, 6);
    const Vec3 centre{0.5, 0.5, 0.5};
    for (Vec3& p : points) p = centre + 0.4 * normalised(p - centre);
    points.push_back(centre);
    const std::vector<Vec3> more = cloud(40, 7);
    points.insert(points.end(), more.begin(), more.end());
    const std::vector<std::int32_t> nodes = all(points.size());
    DelaunayMesh mesh(unit_box());
    mesh.insert(points, {nodes.data(), static_cast<std::size_t>(count)}, kRun);
    mesh.insert(points, {nodes.data() + count, 1}, kRun);
    expect_neighbours(mesh);
    expect_delaunay(mesh, points, {nodes.begin(), nodes.begin() + count + 1});
    mesh.insert(points, {nodes.data() + count + 1, more.size()}, kRun);
    expect_neighbours(mesh);
    expect_delaunay(mesh, points, nodes);
  }
}

TEST(Delaunay, ANodeAtTheVeryPlaceOfAnotherStaysOut) {
  auto points = cloud(50, 3);
  points.push_back(points[17]);
  EXPECT_EQ(sorted_tets(mesh_of(points)), sorted_tets(mesh_of({points.begin(), points.end() - 1})));
}

TEST(Delaunay, TakingNodesOutGivesTheMeshOfTheOthers) {
  const auto points = cloud(500, 4);
  for (const std::size_t count : {1U, 30U, 250U, 499U}) {
    DelaunayMesh mesh = mesh_of(points);
    std::vector<std::int32_t> out;
    for (std::size_t k = 0; k < count; ++k) out.push_back(static_cast<std::int32_t>((k * 7) % 500));
    ASSERT_TRUE(mesh.remove(out, kRun));
    std::vector<std::int32_t> rest;
    for (const std::int32_t n : all(500))
      if (std::find(out.begin(), out.end(), n) == out.end()) rest.push_back(n);
    DelaunayMesh expected(unit_box());
    expected.insert(points, rest, kRun);
    EXPECT_EQ(sorted_tets(mesh), sorted_tets(expected)) << count << " nodes taken out";
  }
}

TEST(Delaunay, NodesTakenOutCanBePutInAgain) {
  const auto points = cloud(400, 5);
  DelaunayMesh mesh = mesh_of(points);
  const std::vector<std::int32_t> some{3, 5, 100, 101, 102, 399};
  ASSERT_TRUE(mesh.remove(some, kRun));
  mesh.insert(points, some, kRun);
  EXPECT_EQ(sorted_tets(mesh), sorted_tets(mesh_of(points)));
}

TEST(Delaunay, MovedNodesGiveTheMeshOfTheirNewPlaces) {
  for (const double step : {1e-6, 1e-3, 1e-2, 5e-2, 0.5}) {
    auto points = cloud(600, 6);
    DelaunayMesh mesh = mesh_of(points);
    Random random(11);
    for (int round = 0; round < 3; ++round) {
      for (std::size_t k = 0; k < points.size(); k += 2)
        for (double* v : {&points[k].x, &points[k].y, &points[k].z})
          *v = std::clamp(*v + step * random.uniform(-1, 1), 0.0, 1.0);
      follow(mesh, points);
      ASSERT_EQ(sorted_tets(mesh), sorted_tets(mesh_of(points))) << "steps of " << step;
    }
  }
}

/// The nodes of a box in a cloud move by `shift`. Where the box comes to lie, a share of the others
/// stays, `rest_in_box`; the rest go.
void move_a_box(const Vec3& shift, double rest_in_box) {
  const auto points = cloud(6000, 13);
  const auto in_box = [](const Vec3& p) { return std::max({p.x, p.y, p.z}) < 0.6; };
  const DelaunayMesh from = mesh_of(points);
  std::vector<Vec3> places;
  std::vector<std::int32_t> names(points.size(), -1);
  Random random(3);
  for (std::size_t n = 0; n < points.size(); ++n) {
    if (in_box(points[n])) {
      names[n] = static_cast<std::int32_t>(places.size());
      places.push_back(points[n] + shift);
    } else if (!in_box(points[n] - shift) || random.uniform() < rest_in_box) {
      places.push_back(points[n]);
    }
  }
  std::vector<std::int32_t> still = all(places.size());
  for (const std::int32_t n : names) std::erase(still, n);
  Box box = unit_box();
  box.add(Vec3{1, 1, 1} + shift);
  DelaunayMesh mesh(box);
  mesh.insert(places, still, kRun);
  mesh.insert_moved(from, names, places, kRun);
  DelaunayMesh expected(box);
  expected.insert(places, all(places.size()), kRun);
  ASSERT_EQ(sorted_tets(mesh), sorted_tets(expected));
  // Its tets hang together: it can be changed.
  follow(mesh, places);
  ASSERT_TRUE(mesh.remove(std::vector<std::int32_t>{names[0] < 0 ? 0 : names[0], 5, 100}, kRun));
}

TEST(Delaunay, NodesThatMoveAsOneBodyBringTheirTetsAlong) {
  move_a_box({0.5, 0.25, 0.375}, 0);
  move_a_box({3, 0, 0}, 0);
}

TEST(Delaunay, ABodyThatGoesWhereOtherNodesStayIsMeshedWithThem) {
  move_a_box({0.5, 0.25, 0.375}, 0.3);
}

TEST(Delaunay, ABodyThatGoesRoundANodeIsMeshedWithIt) {
  // The node is in a hollow of the body, and in none of the balls across the body's own facets.
  const Vec3 middle{0.5, 0.5, 0.5}, shift{3, 0, 0};
  std::vector<Vec3> points = cloud(6000, 13);
  std::erase_if(points, [&](const Vec3& p) { return distance(p, middle) < 0.15; });
  const DelaunayMesh from = mesh_of(points);
  std::vector<Vec3> places = points;
  for (Vec3& p : places) p += shift;
  places.push_back(middle + shift);
  const auto node = static_cast<std::int32_t>(points.size());
  Box box = unit_box();
  box.add(Vec3{1, 1, 1} + shift);
  DelaunayMesh mesh(box);
  mesh.insert(places, std::array{node}, kRun);
  mesh.insert_moved(from, all(points.size()), places, kRun);
  DelaunayMesh expected(box);
  expected.insert(places, all(places.size()), kRun);
  EXPECT_EQ(sorted_tets(mesh), sorted_tets(expected));
}

TEST(Delaunay, MovesTooFarForFlipsChangeNothing) {
  const auto before = cloud(400, 7);
  auto points = before;
  std::swap(points[0], points[1]);
  for (std::size_t k = 2; k < points.size(); k += 2) std::swap(points[k], points[k + 1]);
  DelaunayMesh mesh = mesh_of(before);
  ASSERT_EQ(mesh.move(points, all(400), kRun), DelaunayMesh::Moved::TooFar);
  EXPECT_EQ(sorted_tets(mesh), sorted_tets(mesh_of(before)));
  EXPECT_EQ(mesh.position(0), before[0]);
}

TEST(Delaunay, HeldNodesGoOneByOneWhereTheyCan) {
  // A wave that inverts so many tets that flips would not do if all their nodes stayed behind.
  auto points = cloud(6000, 9);
  DelaunayMesh mesh = mesh_of(points);
  for (Vec3& p : points) p.x = std::clamp(p.x + 0.01 * std::sin(40 * p.y), 0.0, 1.0);
  ASSERT_EQ(follow(mesh, points), DelaunayMesh::Moved::Done);
  EXPECT_EQ(sorted_tets(mesh), sorted_tets(mesh_of(points)));
}

TEST(Delaunay, NodesSlidingInAPlaneAreFlippedThere) {
  // A layer of coplanar nodes between two others: moves in the plane need 4-4 flips.
  Random random(12);
  std::vector<Vec3> points;
  for (int k = 0; k < 300; ++k)
    points.push_back({random.uniform(), random.uniform(),
                      k % 3 == 0   ? 0.5
                      : k % 3 == 1 ? random.uniform(0, 0.4)
                                   : random.uniform(0.6, 1)});
  DelaunayMesh mesh = mesh_of(points);
  for (int round = 0; round < 5; ++round) {
    for (std::size_t k = 0; k < points.size(); k += 3) {
      points[k].x = std::clamp(points[k].x + 0.01 * random.uniform(-1, 1), 0.0, 1.0);
      points[k].y = std::clamp(points[k].y + 0.01 * random.uniform(-1, 1), 0.0, 1.0);
    }
    follow(mesh, points);
    ASSERT_EQ(sorted_tets(mesh), sorted_tets(mesh_of(points)));
  }
}

TEST(Delaunay, RenamedNodesKeepTheirPlaces) {
  const auto points = cloud(100, 8);
  DelaunayMesh mesh = mesh_of(points);
  std::vector<std::int32_t> names(100);
  for (int k = 0; k < 100; ++k) names[k] = 149 - k;
  mesh.rename(names, 150);
  std::vector<Vec3> renamed(150);
  for (int k = 0; k < 100; ++k) renamed[149 - k] = points[k];
  std::vector<std::int32_t> inserted(100);
  std::iota(inserted.begin(), inserted.end(), 50);
  expect_delaunay(mesh, renamed, inserted);
  EXPECT_EQ(mesh.position(149), points[0]);
}

TEST(Delaunay, AStopRequestEndsInsertion) {
  std::stop_source source;
  source.request_stop();
  remeshd::Run run;
  run.stop = source.get_token();
  DelaunayMesh mesh(unit_box());
  const auto points = cloud(1000, 9);
  EXPECT_ANY_THROW(mesh.insert(points, all(1000), run));
}

}  // namespace
}  // namespace remeshd
