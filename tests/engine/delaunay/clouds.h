#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "engine/base/random.h"
#include "engine/delaunay/delaunay_mesh.h"
#include "engine/mesh/tet_mesh.h"
#include "tests/support/run.h"

/// Delaunay meshes of random nodes in the unit cube.
namespace remeshd::test {

inline Box unit_box() {
  Box box;
  box.add(Vec3{0, 0, 0});
  box.add(Vec3{1, 1, 1});
  return box;
}

inline std::vector<std::int32_t> all(std::size_t n) {
  std::vector<std::int32_t> nodes(n);
  std::iota(nodes.begin(), nodes.end(), 0);
  return nodes;
}

inline std::vector<Vec3> cloud(int n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> points(n);
  for (Vec3& p : points) p = {random.uniform(), random.uniform(), random.uniform()};
  return points;
}

inline DelaunayMesh mesh_of(const std::vector<Vec3>& points) {
  DelaunayMesh mesh(unit_box());
  mesh.insert(points, all(points.size()), kRun);
  return mesh;
}

inline std::vector<Tet> sorted_tets(const DelaunayMesh& mesh) {
  std::vector<Tet> tets;
  mesh.for_each_tet([&](Tet t) {
    std::sort(t.begin(), t.end());
    tets.push_back(t);
  });
  std::sort(tets.begin(), tets.end());
  return tets;
}

/// Brings the mesh to where the points are now. Returns how flips got on.
inline DelaunayMesh::Moved follow(DelaunayMesh& mesh, const std::vector<Vec3>& points) {
  const auto moved = mesh.move(points, all(points.size()), kRun);
  if (moved == DelaunayMesh::Moved::TooFar) {
    EXPECT_TRUE(mesh.reinsert(points, all(points.size()), kRun));
  }
  EXPECT_NE(moved, DelaunayMesh::Moved::Failed);
  return moved;
}

}  // namespace remeshd::test
