#include <gtest/gtest.h>

#include <set>

#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"
#include "tests/support/stored.h"

namespace remeshd {
namespace {

/// Chains that go different ways, each step from the revision in memory and, with other threads,
/// from the same one stored and loaded.
TEST(Determinism, StateInMemoryEqualsStateLoadedAgainWithAnyNumberOfThreads) {
  struct Step {
    const char* parameter;
    double value;
    MeshOptions options;
  };
  const MeshOptions poor{.iterations = 1, .start = MeshOptions::Start::Random};
  std::set<Way> ways;
  for (const auto& [model, steps] : std::vector<std::pair<const char*, std::vector<Step>>>{
           {"tool1-a",
            {{"hole_circle", 36.02, {}}, {"pin_radius", 5, {}}, {"pin_radius", 5 + 1e-13, {}}}},
           {"tool3-a", {{"width", 72, poor}, {"boss_x", 33, {}}, {"boss_x", 33.02, {}}}}}) {
    ModelSource source = test::case_model(model);
    Revision r = make_revision(nullptr, source, {.nodes = 1000}, {.threads = 1});
    EXPECT_TRUE(test::stored_bytes(r) == test::stored_bytes(make_revision(
                                             nullptr, source, {.nodes = 1000}, {.threads = 5})));
    for (int threads = 2; const Step& step : steps) {
      test::parameter(source, step.parameter) = step.value;
      const Revision loaded = test::stored_and_loaded(r);
      const Revision other = make_revision(&loaded, source, step.options, {.threads = threads++});
      r = make_revision(&r, source, step.options, {.threads = 1});
      ways.insert(r.report.way);
      // Not EXPECT_EQ, which would print megabytes.
      EXPECT_TRUE(test::stored_bytes(r) == test::stored_bytes(other))
          << model << " " << step.parameter;
    }
  }
  EXPECT_EQ(ways, (std::set{Way::Unchanged, Way::Morphed, Way::Local, Way::Renewed}));
}

}  // namespace
}  // namespace remeshd
