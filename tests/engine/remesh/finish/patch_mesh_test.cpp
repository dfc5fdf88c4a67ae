#include "engine/remesh/finish/patch_mesh.h"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace remeshd
