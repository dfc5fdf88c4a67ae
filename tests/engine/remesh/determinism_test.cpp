#include <gtest/gtest.h>

#include <cstdint>
#include <set>

#include "engine/model/feature_model.h"
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

/// The base size is solved for, beginning with a guess for which details would be resolved that are
/// not for the base size found: a step of .1, of which the first edit of the mesh in memory still
/// knew.
TEST(Determinism, EditsOfAFirstMeshWithSizesAreThoseOfTheMeshLoadedAgain) {
  ModelSource source = test::model_of(
      {test::block("a", 40, 20, 10), test::placed(test::block("b", 20, 20, 10), 10.1, 0, 5),
       test::placed(test::cylinder("h", 2, 60), -10, 0, -20, Nature::Subtractive)});
  source.sizes = {{"fine", "b", "dz/5"}};
  const MeshOptions options{.sizing = {.even = false}};
  MeshOptions first = options;
  first.nodes = 500;
  const Revision r = make_revision(Revision::none(), source, first, {.threads = 1});
  const Revision loaded = test::stored_and_loaded(r);
  for (const double dz : {9.8, 10.3}) {
    const ModelSource now = apply(source, {{SetFeatureParameter{"b", "dz", Scalar(dz)}}});
    EXPECT_TRUE(test::stored_bytes(make_revision(r, now, options, {.threads = 1})) ==
                test::stored_bytes(make_revision(loaded, now, options, {.threads = 2})))
        << dz;
  }
}

}  // namespace
}  // namespace remeshd
