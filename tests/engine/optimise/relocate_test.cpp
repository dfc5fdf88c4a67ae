#include "engine/optimise/relocate.h"

#include <gtest/gtest.h>

#include "engine/mesh/quality.h"

namespace remeshd {
namespace {

InsideTest cube() {
  return
      [](const Vec3& p) { return std::fabs(p.x) < 2 && std::fabs(p.y) < 2 && p.z > 0 && p.z < 4; };
}

/// A node in an octahedron of six fixed ones, off its centre.
struct Octahedron {
  NodeSet nodes;
  std::vector<Tet> tets;

  explicit Octahedron(const Vec3& middle) {
    for (const Vec3& p : {Vec3{1, 0, 2}, Vec3{-1, 0, 2}, Vec3{0, 1, 2}, Vec3{0, -1, 2},
                          Vec3{0, 0, 3}, Vec3{0, 0, 1}}) {
      nodes.add_new(p);
      nodes.state.back() = NodeState::Fixed;
    }
    nodes.add_new(middle);
    for (const std::int32_t x : {0, 1})
      for (const std::int32_t y : {2, 3})
        for (const std::int32_t z : {4, 5}) {
          Tet t{x, y, z, 6};
          const auto& p = nodes.positions;
          if (tet_volume(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) < 0) std::swap(t[0], t[1]);
          tets.push_back(t);
        }
  }
};

TEST(Relocate, ANodeMovesToTheVolumeWeightedMeanOfTheCircumcentres) {
  Octahedron o({0.2, -0.1, 2.15});
  relocate(o.nodes, o.tets, cube(), NodeLengths(1), {});
  // Formula (1) by hand, with circumcentres from the three bisector planes.
  Vec3 sum{};
  double volume = 0;
  const Octahedron before({0.2, -0.1, 2.15});
  for (const Tet& t : before.tets) {
    const auto& p = before.nodes.positions;
    const Vec3 a = p[t[0]], u = p[t[1]] - a, v = p[t[2]] - a, w = p[t[3]] - a;
    const double det = 2 * dot(u, cross(v, w));
    const Vec3 c =
        a + (norm2(u) * cross(v, w) + norm2(v) * cross(w, u) + norm2(w) * cross(u, v)) / det;
    sum += (det / 12) * c;
    volume += det / 12;
  }
  EXPECT_LT(distance(o.nodes.positions[6], sum / volume), 1e-12);
}

TEST(Relocate, TheCentreOfASymmetricRingStays) {
  Octahedron o({0, 0, 2});
  relocate(o.nodes, o.tets, cube(), NodeLengths(1), {});
  EXPECT_LT(distance(o.nodes.positions[6], {0, 0, 2}), 1e-14);
}

TEST(Relocate, ANodeGoesWhereTheFieldIsFiner) {
  const Surface plane{Surface::Kind::Plane, Transform::translation({0, 0, 3}), 0, 0};
  const Box all{{-9, -9, -9}, {9, 9, 9}};
  const SizeField finer_above({.base = 2, .least = 0.5, .slope = 0.3}, {{plane, all, 0.5}}, all);
  Octahedron o({0, 0, 2});
  NodeLengths lengths(finer_above);
  lengths.follow(o.nodes.positions, {});
  relocate(o.nodes, o.tets, cube(), lengths, {});
  EXPECT_GT(o.nodes.positions[6].z, 2.01);
  EXPECT_LT(norm(o.nodes.positions[6] - Vec3{0, 0, o.nodes.positions[6].z}), 1e-14);
}

TEST(Relocate, FixedAndBoundaryNodesStay) {
  Octahedron fixed({0.2, 0, 2});
  fixed.nodes.state[6] = NodeState::Fixed;
  relocate(fixed.nodes, fixed.tets, cube(), NodeLengths(1), {});
  EXPECT_EQ(fixed.nodes.positions[6], (Vec3{0.2, 0, 2}));
  Octahedron boundary({0.2, 0, 2});
  boundary.nodes.supports[6] = {Support::Kind::Face, 0};
  relocate(boundary.nodes, boundary.tets, cube(), NodeLengths(1), {});
  EXPECT_EQ(boundary.nodes.positions[6], (Vec3{0.2, 0, 2}));
}

TEST(Relocate, ANodeInTheBoundaryThatTetsOutsidePullOutGoesIn) {
  // Half of the octahedron, the larger one, is outside.
  Octahedron o({0.1, 0, 2});
  o.nodes.positions[4].z = 6;
  const InsideTest below = [](const Vec3& p) { return p.z <= 2; };
  relocate(o.nodes, o.tets, below, NodeLengths(1), {});
  EXPECT_LT(o.nodes.positions[6].z, 1.99);
  EXPECT_GT(o.nodes.positions[6].z, 1);
}

}  // namespace
}  // namespace remeshd
