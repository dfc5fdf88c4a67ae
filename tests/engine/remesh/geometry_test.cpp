#include <gtest/gtest.h>

#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"
#include "tests/support/stored.h"

namespace remeshd {
namespace {

using test::kRun;

TEST(ReportedGeometry, TellsHowTheBoundaryCameAbout) {
  const ModelSource source = test::case_model("simple-a");
  const Revision first = make_revision(Revision::none(), source, {.nodes = 200}, kRun);
  EXPECT_EQ(first.report.geometry, "fused");
  const Revision moved = make_revision(
      first, apply(source, ModelEdit{{SetParameter{"top_x", Scalar(5.0)}}}), {}, kRun);
  EXPECT_EQ(moved.report.geometry, "swept");
  const Revision same = make_revision(moved, moved.source, {}, kRun);
  EXPECT_EQ(same.report.geometry, "kept");
  EXPECT_EQ(test::stored_and_loaded(moved).report.geometry, "swept");
}

TEST(ReportedGeometry, OfAnEditThatOnlyTheCadKernelCanDrawIsFusedWhereItIs) {
  const ModelSource plate = test::model_of(
      {test::block("plate", 60, 60, 10), test::placed(test::block("boss", 8, 8, 8), -20, -20, 10)});
  const Revision first = make_revision(Revision::none(), plate, {.nodes = 200}, kRun);
  FeatureSource ball = test::placed(test::feature("ball", "sphere", {{"radius", 6.0}}), 20, 20, 9);
  const Revision with =
      make_revision(first, apply(plate, ModelEdit{{AddFeature{ball, ""}}}), {}, kRun);
  EXPECT_EQ(with.report.geometry, "fused in part");
}

}  // namespace
}  // namespace remeshd
