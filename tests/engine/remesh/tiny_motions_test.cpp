// Edits that move features by next to nothing, but beside others.
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"
#include "tests/support/stored.h"

namespace remeshd {
namespace {

using test::kRun;

/// A plate with a lug, flush at the top where their heights are the same. The diagonal is 60.
ModelSource plate_with_lug(double plate_height, double lug_width) {
  return test::model_of({test::block("plate", 40, 40, plate_height),
                         test::placed(test::block("lug", lug_width, 14, 20), 20, 0, 0)});
}

bool has_left_out(const Revision& r, const std::string& feature) {
  return std::ranges::any_of(r.report.warnings, [&](const Warning& w) {
    return w.code == WarningCode::DetailNotResolved && w.features == std::vector{feature};
  });
}

class TinyStep : public testing::Test {
 protected:
  static constexpr double kStep = 4e-6;  // less than 5e-7 x the diagonal

  Revision edit(const Revision& base, double plate_height, double lug_width) const {
    return make_revision(base, plate_with_lug(plate_height, lug_width), options_, kRun);
  }

  const MeshOptions options_{.nodes = 600, .sizing = {.even = false}};
  const Revision base_ = make_revision(Revision::none(), plate_with_lug(20, 30), options_, kRun);
};

TEST_F(TinyStep, KeepsTheMeshAndIsToldOf) {
  MeshOptions inherited = base_.options;
  inherited.nodes.reset();
  const Revision r = make_revision(base_, plate_with_lug(20 + kStep, 30), inherited, kRun);
  EXPECT_EQ(r.report.strategy, MeshStrategy::Unchanged);
  EXPECT_TRUE(has_left_out(r, "plate"));
  EXPECT_EQ(r.source, plate_with_lug(20 + kStep, 30));
}

TEST_F(TinyStep, CountsInTheExactVolume) {
  const Revision r = edit(base_, 20 + kStep, 30);
  EXPECT_NEAR(r.report.exact_volume - base_.report.exact_volume, 1600 * kStep, 1e-6);
}

TEST_F(TinyStep, IsLeftOutBesideARealChange) {
  const Revision r = edit(base_, 20 + kStep, 40);
  EXPECT_EQ(r.report.strategy, MeshStrategy::Local);
  EXPECT_TRUE(has_left_out(r, "plate"));
  EXPECT_EQ(r.report.last_resort_share, 0);
  EXPECT_GT(r.report.quality.dihedral_min, 15 * 3.14159 / 180);
}

TEST_F(TinyStep, IsStillLeftOutOneEditLater) {
  const Revision once = edit(base_, 20 + kStep, 40);
  const Revision twice = edit(once, 20 + kStep, 36);
  EXPECT_EQ(twice.report.strategy, MeshStrategy::Local);
  EXPECT_TRUE(has_left_out(twice, "plate"));
}

TEST_F(TinyStep, DoesNotAddUpUnseen) {
  Revision r = base_;
  int left_out = 0;
  for (int k = 1; k <= 9; ++k) {
    r = edit(r, 20 + k * kStep, 30);
    left_out += has_left_out(r, "plate") ? 1 : 0;
  }
  EXPECT_GE(left_out, 1);
  EXPECT_LT(left_out, 9);
}

TEST_F(TinyStep, IsLeftOutOfWhatIsLoadedToo) {
  const Revision r = edit(base_, 20 + kStep, 40);
  const Revision loaded = test::stored_and_loaded(r);
  EXPECT_TRUE(same_geometry(loaded.model, r.model));
  EXPECT_EQ(motion_bound(loaded.model, r.model), 0);
  EXPECT_EQ(test::stored_bytes(edit(loaded, 20 + kStep, 36)),
            test::stored_bytes(edit(r, 20 + kStep, 36)));
}

TEST_F(TinyStep, ThatLeavesNoSlitIsMeshed) {
  const Revision r = edit(base_, 30, 30);  // no longer flush
  const Revision next = edit(r, 30 + kStep, 40);
  EXPECT_EQ(next.report.strategy, MeshStrategy::Local);
  EXPECT_FALSE(has_left_out(next, "plate"));
  EXPECT_EQ(next.meshed_source, next.source);
}

}  // namespace
}  // namespace remeshd
