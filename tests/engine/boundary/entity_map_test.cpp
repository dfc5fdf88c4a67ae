#include "engine/boundary/entity_map.h"

#include <gtest/gtest.h>

#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

/// A block, and the same with a slot through the middle of its top.
struct CutInTwo {
  CellularModel before =
      build_cells(evaluate(test::model_of({test::block("base", 20, 10, 5)})), kRun);
  CellularModel after = build_cells(evaluate(with_slot()), kRun);
  EntityMap map{before.boundary, after.boundary, 1e-6};

  static ModelSource with_slot() {
    FeatureSource slot = test::placed(test::block("slot", 4, 20, 2), 0, 0, 4);
    slot.nature = Nature::Subtractive;
    return test::model_of({test::block("base", 20, 10, 5), slot});
  }
};

int face_at(const BoundaryModel& boundary, const Vec3& normal_there, const Vec3& p) {
  for (int f = 0; f < static_cast<int>(boundary.faces.size()); ++f) {
    const BoundaryFace& face = boundary.faces[f];
    const Vec3 n = (face.reversed ? -1.0 : 1.0) * normal(face.surface, p);
    Box box;
    for (const Vec3& q : face.points) box.add(q);
    if (dot(n, normal_there) > 0.9 && box.contains(p, 1e-9)) return f;
  }
  return -1;
}

TEST(EntityMap, FindsThePieceOfAFaceThatWasCutInTwo) {
  const CutInTwo c;
  const int top = face_at(c.before.boundary, {0, 0, 1}, {0, 0, 5});
  ASSERT_GE(top, 0);
  for (const double x : {-7.0, 7.0}) {
    const auto now = c.map({Support::Kind::Face, top}, {x, 1, 5});
    ASSERT_TRUE(now.has_value());
    EXPECT_EQ(now->entity, face_at(c.after.boundary, {0, 0, 1}, {x, 1, 5}));
  }
}

TEST(EntityMap, FindsThePieceOfAnEdgeThatWasCutInTwo) {
  const CutInTwo c;
  for (int e = 0; e < static_cast<int>(c.before.boundary.edges.size()); ++e) {
    const BoundaryEdge& edge = c.before.boundary.edges[e];
    const Vec3 p = edge.points.front() + 0.1 * (edge.points.back() - edge.points.front());
    const auto now = c.map({Support::Kind::Edge, e}, p);
    ASSERT_TRUE(now.has_value());
    EXPECT_LT(distance(project(c.after.boundary, *now, p), p), 1e-9);
  }
}

TEST(EntityMap, ToItselfChangesNothing) {
  const CutInTwo c;
  const EntityMap same(c.after.boundary, c.after.boundary, 1e-6);
  const auto expect_same = [&](Support::Kind kind, std::size_t count, const auto& point_on) {
    for (int i = 0; i < static_cast<int>(count); ++i)
      EXPECT_EQ(same({kind, i}, point_on(i)), (Support{kind, i}));
  };
  const BoundaryModel& b = c.after.boundary;
  expect_same(Support::Kind::Vertex, b.vertices.size(),
              [&](int v) { return b.vertices[v].position; });
  expect_same(Support::Kind::Edge, b.edges.size(),
              [&](int e) { return 0.5 * (b.edges[e].points.front() + b.edges[e].points.back()); });
  expect_same(Support::Kind::Face, b.faces.size(), [&](int f) {
    const auto& [i, j, k] = b.faces[f].triangles.front();
    return (b.faces[f].points[i] + b.faces[f].points[j] + b.faces[f].points[k]) / 3.0;
  });
  EXPECT_EQ(same({}, {1, 2, 3}), Support{});
}

TEST(EntityMap, HasNothingForAVertexThatIsGone) {
  const CutInTwo c;
  const EntityMap back(c.after.boundary, c.before.boundary, 1e-6);
  for (int v = 0; v < static_cast<int>(c.after.boundary.vertices.size()); ++v) {
    const Vec3& p = c.after.boundary.vertices[v].position;
    EXPECT_EQ(back({Support::Kind::Vertex, v}, p).has_value(), std::fabs(p.x) > 9);
  }
}

}  // namespace
}  // namespace remeshd
