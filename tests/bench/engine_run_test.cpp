#include "tests/bench/engine_run.h"

#include <gmock/gmock.h>

#include "tests/bench/paper_figures.h"

namespace remeshd::bench {
namespace {

using testing::DoubleNear;
using testing::Optional;

TEST(MeshOptionsOfARun, FollowItsSwitches) {
  const EngineRun ours{.nodes = 2000, .iterations = 5, .seed = 3};
  EXPECT_EQ(mesh_options(ours).nodes, 2000U);
  EXPECT_EQ(mesh_options(ours).iterations, 5U);
  EXPECT_EQ(mesh_options(ours).seed, 3U);
  EXPECT_EQ(mesh_options(ours).start, MeshOptions::Start::Lattice);
  EXPECT_TRUE(mesh_options(ours).sizing.even);
  EXPECT_FALSE(mesh_options({.sized = true}).sizing.even);
  const EngineRun papers{.switches = {.paper = true}};
  EXPECT_EQ(mesh_options(papers).start, MeshOptions::Start::Random);
  EXPECT_TRUE(mesh_options(papers).rebuild);
  EXPECT_FALSE(mesh_options(ours).rebuild);
}

TEST(PaperRatio, IsThatOfTable3) {
  EXPECT_THAT(paper_ratio("simple-ab", 15000, 5), Optional(DoubleNear(.1062, 1e-12)));
  EXPECT_THAT(paper_ratio("tool1-ac", 30000, 10), Optional(DoubleNear(.133, 1e-12)));
  EXPECT_THAT(paper_ratio("tool3-ab", 30000, 5), Optional(DoubleNear(.3055, 1e-12)));
  EXPECT_EQ(paper_ratio("tool2-cd", 15000, 10), std::nullopt);
  EXPECT_EQ(paper_ratio("simple-ab", 100000, 10), std::nullopt);
  EXPECT_EQ(paper_ratio("simple-ab", 15000, 0), std::nullopt);
}

}  // namespace
}  // namespace remeshd::bench
