#include "engine/remesh/steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/remesh/remesh.h"
#include "engine/revision/delaunay_state.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

const Strategy& strategy(const std::string& name) {
  return *std::ranges::find(strategies(), name, &Strategy::name);
}

/// A task of an edit, up to where nodes would be copied.
struct EditTask {
  EditTask(const ModelSource& model, const ModelEdit& edit)
      : base(make_revision(Revision::none(), model, {.nodes = 3000, .iterations = 5}, kRun)),
        modified(to_be_meshed(apply(model, edit))) {}
  static Revision to_be_meshed(const ModelSource& source) {
    Revision r;
    r.source = source;
    r.model = evaluate(source);
    r.options = {.iterations = 5};
    r.cells = build_cells(r.model, kRun);
    return r;
  }
  double edge_length() const { return problem.density.sizes.base(); }

  const Revision base;
  const Revision modified;
  const Problem problem{base, modified,
                        resolve_density(base, {}, modified.model, modified.cells, kRun), kRun};
  const Strategy& how = strategy("local, 4 edge lengths");
  const MeshingTask task{how, problem, nullptr};
  Attempt attempt{how.name};
};

TEST(CopyAndFill, LooksAtTheNodesWithinTwoEdgeLengthsOfWhatChanges) {
  EditTask edit(test::case_model("simple-a"), test::case_edit("simple-ab"));
  const std::optional<PatchNodes> local = copy_and_fill(edit.task, edit.attempt);
  ASSERT_TRUE(local);
  // Those that are not looked at come first, with the supports that the map of entities gives them.
  std::size_t not_looked_at = 0;
  for (std::int32_t n = 0; n < local->placed; ++n) {
    const Vec3& p = local->patch.positions[local->nodes.original[n]];
    EXPECT_FALSE(edit.task.plan.in_changed(p, 2 * edit.edge_length()))
        << p.x << ' ' << p.y << ' ' << p.z;
    ++not_looked_at;
  }
  EXPECT_GT(not_looked_at, 50U);
}

TEST(Optimise, FreesAnotherLayerAfterTheFirstIterationAndTheFourth) {
  EditTask edit(test::case_model("simple-a"), test::case_edit("simple-ab"));
  PatchNodes local = *copy_and_fill(edit.task, edit.attempt);
  const SampledBoundary boundary = sample(edit.task, local, edit.attempt);
  const OptimiseResult loop = optimise(edit.task, local, boundary, edit.attempt);
  const std::vector<std::uint32_t>& free = loop.free_per_iteration;
  ASSERT_EQ(free.size(), 5U);
  EXPECT_GT(free[1], free[0] + free[0] / 10);
  EXPECT_GT(free[4], free[3] + free[3] / 10);
}

TEST(ExtractVerified, WhatMeetsAChangedBoxIsNotTakenForWhatItWas) {
  // A pin on a plate gets thicker, and inside of the plate beside it there is another block, which
  // changes nothing: tets in its box are those that they were.
  const FeatureSource hidden = test::placed(test::block("hidden", 4, 4, 4), 6, 0, 3);
  EditTask edit(test::model_of({test::block("plate", 40, 40, 10),
                                test::placed(test::cylinder("pin", 3, 10), 0, 0, 10)}),
                {{SetFeatureParameter{"pin", "radius", 3.5}, AddFeature{hidden, ""}}});
  PatchNodes local = *copy_and_fill(edit.task, edit.attempt);
  const SampledBoundary boundary = sample(edit.task, local, edit.attempt);
  OptimiseResult loop = optimise(edit.task, local, boundary, edit.attempt);
  Box box;
  box.add(Vec3{4.1, -1.9, 3.1});
  box.add(Vec3{7.9, 1.9, 6.9});
  std::size_t untrue = 0;
  MeshPatch& patch = local.patch;
  for (std::int32_t s = 0; s < static_cast<std::int32_t>(patch.inside.size()); ++s) {
    if (!patch.inside[s]) continue;
    Vec3 centroid;
    for (const std::int32_t n : patch.mesh.corners(s)) centroid += 0.25 * patch.positions[n];
    if (!box.contains(centroid)) continue;
    patch.inside[s] = 0;  // as if the base had been void there
    ++untrue;
  }
  EXPECT_GT(untrue, 20U);
  const Candidate mesh =
      extract_verified(edit.task, std::move(local), std::move(loop), boundary, edit.attempt);
  EXPECT_TRUE(mesh.verification.valid) << mesh.verification.failures.front().what;
}

}  // namespace
}  // namespace remeshd
