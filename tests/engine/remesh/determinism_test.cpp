#include <gtest/gtest.h>

#include <cstdint>
#include <set>

#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"
#include "tests/support/chains.h"
#include "tests/support/stored.h"

namespace remeshd {
namespace {

/// Chains that go different ways, each step from the revision in memory and, with other threads,
/// from the same one stored and loaded.
void expect_the_same_bytes(std::uint32_t order) {
  std::set<MeshStrategy> strategies;
  for (const test::Chain& chain : test::chains_that_go_all_ways()) {
    ModelSource source = test::case_model(chain.model);
    const MeshOptions first{.nodes = 1000, .order = order};
    Revision r = make_revision(Revision::none(), source, first, {.threads = 1});
    EXPECT_TRUE(test::stored_bytes(r) ==
                test::stored_bytes(make_revision(Revision::none(), source, first, {.threads = 5})));
    for (int threads = 2; const test::Chain::Step& step : chain.steps) {
      test::parameter(source, step.parameter) = step.value;
      MeshOptions options = step.options;
      options.order = order;
      const Revision loaded = test::stored_and_loaded(r);
      const Revision other = make_revision(loaded, source, options, {.threads = threads++});
      r = make_revision(r, source, options, {.threads = 1});
      strategies.insert(r.report.strategy);
      // Not EXPECT_EQ, which would print megabytes.
      EXPECT_TRUE(test::stored_bytes(r) == test::stored_bytes(other))
          << chain.model << " " << step.parameter;
    }
  }
  EXPECT_EQ(strategies, (std::set{MeshStrategy::Unchanged, MeshStrategy::Morphed,
                                  MeshStrategy::Local, MeshStrategy::Renewed}));
}

TEST(Determinism, StateInMemoryEqualsStateLoadedAgainWithAnyNumberOfThreads) {
  expect_the_same_bytes(1);
}

TEST(Determinism, TheSameHoldsOfMidNodes) { expect_the_same_bytes(2); }

}  // namespace
}  // namespace remeshd
