#include "engine/remesh/finish/patch_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

/// A round flange with a barrel on it that has a port at a height.
ModelSource valve(double height) {
  return test::model_of({test::cylinder("flange", 35, 9), test::cylinder("barrel", 20, 60),
                         test::placed(test::block("port", 12, 12, 12), 31, 0, height),
                         test::placed(test::block("neck", 24, 6, 6), 22, 0, height + 3)});
}

TEST(PatchMesh, HasNoTetsWhereThereWereNoneAndNothingChanged) {
  // The port is in the balls of flat tets outside of the flange. What came in their place once it
  // had moved lay against the flange, between nodes that stayed: it was taken in, TetGen filled the
  // place, and with it a fifth of the flange was lost.
  MeshOptions options{.nodes = 3000, .seed = 2};
  options.sizing.even = false;
  const Revision base = make_revision(Revision::none(), valve(25), options, kRun);
  options.nodes.reset();
  const Revision moved = make_revision(base, valve(26.3), options, kRun);
  EXPECT_TRUE(moved.report.attempts.empty()) << moved.report.attempts.front().reason;
  EXPECT_EQ(moved.report.last_resort_share, 0);
  const auto on_flange = [](const Vec3& p) { return p.z < 8 && std::hypot(p.x, p.y) > 22; };
  int there = 0, kept = 0;
  for (const Vec3& p : base.output.mesh.nodes) there += on_flange(p) ? 1 : 0;
  for (std::size_t n = 0; n < moved.output.mesh.nodes.size(); ++n)
    kept +=
        moved.output.map.node_origin[n] == NodeOrigin::Kept && on_flange(moved.output.mesh.nodes[n])
            ? 1
            : 0;
  EXPECT_EQ(kept, there);
}

/// A turned shaft with a collar and a fillet between them.
ModelSource shaft(double collar, double fillet) {
  using test::arc, test::point;
  const double between = fillet * (1 - std::sqrt(0.5));
  return test::one_feature(test::feature(
      "shaft", "revolution",
      {point(0.0, 0.0), point(collar, 0.0), point(collar, 5.0), point(5 + fillet, 5.0),
       arc(5.0, 5 + fillet, 5 + between, 5 + between), point(5.0, 30.0), point(0.0, 30.0)},
      {{"angle", 360.0}}));
}

TEST(PatchMesh, OfAFeatureThatChangesShapeKeepsWhatTheShapesShare) {
  // Flat tets against the side of the shaft are outside, and the fillet changes in the balls of
  // some. They were taken in where others on top of them, left out before, were beyond the patch:
  // all of the shaft was made anew, in twice the time of its first mesh.
  MeshOptions options{.nodes = 5000};
  options.sizing.even = false;
  const Revision base = make_revision(Revision::none(), shaft(10, 2), options, kRun);
  options.nodes.reset();
  // With a smaller collar other tets come in the place of those that were outside.
  for (const ModelSource& other : {shaft(10, 2.1), shaft(9.5, 2)}) {
    const Revision edited = make_revision(base, other, options, kRun);
    EXPECT_TRUE(edited.report.attempts.empty()) << edited.report.attempts.front().reason;
    EXPECT_GE(edited.report.counts.nodes_kept, 0.75 * base.report.counts.nodes);
    EXPECT_GE(edited.report.quality.dihedral_min, 25);
  }
}

/// The corners of a lattice of 4 x 4 x 4 cubes, each with a sphere of its own.
NodeSet lattice() {
  NodeSet nodes;
  for (int k = 0; k < 5; ++k)
    for (int j = 0; j < 5; ++j)
      for (int i = 0; i < 5; ++i) nodes.add_new(Vec3{1.0 * i, 1.0 * j, 1.0 * k});
  return nodes;
}

TEST(DropUnused, TellsWhereTheDelaunayMeshHadToBeBuiltAnew) {
  // The tets in the peeled mesh are known by their slots, and would be sought in those of a mesh
  // that was there before.
  int rebuilt = 0;
  for (std::int32_t left_out = 0; left_out < lattice().size(); ++left_out) {
    SCOPED_TRACE(left_out);
    NodeSet nodes = lattice();
    DelaunayMesh mesh(box_of(nodes.positions));
    std::vector<std::int32_t> unused(nodes.positions.size());
    std::iota(unused.begin(), unused.end(), 0);
    mesh.insert(nodes.positions, unused, kRun);
    std::vector<Tet> tets;
    mesh.for_each_tet([&](const Tet& t) {
      if (std::ranges::find(t, left_out) != t.end()) return;
      tets.push_back(t);
      for (const std::int32_t n : t) std::erase(unused, n);
    });
    DelaunayMesh without = mesh;
    const bool can_be_removed = without.remove(unused, kRun);
    const DroppedNodes dropped = drop_unused(nodes, tets, mesh, kRun);
    EXPECT_EQ(dropped.rebuilt, !can_be_removed);
    EXPECT_EQ(dropped.number[left_out], -1);
    rebuilt += dropped.rebuilt ? 1 : 0;
  }
  EXPECT_GT(rebuilt, 0);
}

}  // namespace
}  // namespace remeshd
