#include <gtest/gtest.h>

#include <set>

#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"
#include "tests/support/chains.h"
#include "tests/support/stored.h"

namespace remeshd {
namespace {

/// Chains that go different ways, each step from the revision in memory and, with other threads,
/// from the same one stored and loaded.
TEST(Determinism, StateInMemoryEqualsStateLoadedAgainWithAnyNumberOfThreads) {
  std::set<MeshStrategy> strategies;
  for (const test::Chain& chain : test::chains_that_go_all_ways()) {
    ModelSource source = test::case_model(chain.model);
    Revision r = make_revision(Revision::none(), source, {.nodes = 1000}, {.threads = 1});
    EXPECT_TRUE(test::stored_bytes(r) ==
                test::stored_bytes(
                    make_revision(Revision::none(), source, {.nodes = 1000}, {.threads = 5})));
    for (int threads = 2; const test::Chain::Step& step : chain.steps) {
      test::parameter(source, step.parameter) = step.value;
      const Revision loaded = test::stored_and_loaded(r);
      const Revision other = make_revision(loaded, source, step.options, {.threads = threads++});
      r = make_revision(r, source, step.options, {.threads = 1});
      strategies.insert(r.report.strategy);
      // Not EXPECT_EQ, which would print megabytes.
      EXPECT_TRUE(test::stored_bytes(r) == test::stored_bytes(other))
          << chain.model << " " << step.parameter;
    }
  }
  EXPECT_EQ(strategies, (std::set{MeshStrategy::Unchanged, MeshStrategy::Morphed,
                                  MeshStrategy::Local, MeshStrategy::Renewed}));
}

}  // namespace
}  // namespace remeshd
