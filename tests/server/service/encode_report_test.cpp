#include "server/service/encode_report.h"

#include <gtest/gtest.h>

namespace remeshd {
namespace {

TEST(EncodedReport, TellsWhatWasTriedInItsOrder) {
  HeldRevision held;
  held.revision.report.attempts = {{"morphed", "a tet would have missed the goals", 0.125},
                                   {"local, 4 edge lengths", "a facet is missing", 0.25}};
  const auto report = encode_report(held);
  ASSERT_EQ(report.attempts_size(), 2);
  EXPECT_EQ(report.attempts(0).strategy(), "morphed");
  EXPECT_EQ(report.attempts(0).reason(), "a tet would have missed the goals");
  EXPECT_EQ(report.attempts(0).seconds(), 0.125);
  EXPECT_EQ(report.attempts(1).strategy(), "local, 4 edge lengths");
}

TEST(EncodedReport, TellsHowTheBoundaryCameAbout) {
  HeldRevision held;
  held.revision.report.geometry = "crossed";
  held.revision.report.geometry_seconds = 0.5;
  held.revision.report.geometry_attempts = {{"swept", "no common axis", 0.25}};
  const auto diagnostics = encode_report(held).diagnostics();
  EXPECT_EQ(diagnostics.geometry(), "crossed");
  EXPECT_EQ(diagnostics.geometry_seconds(), 0.5);
  ASSERT_EQ(diagnostics.geometry_attempts_size(), 1);
  EXPECT_EQ(diagnostics.geometry_attempts(0).seconds(), 0.25);
}

TEST(EncodedReport, TellsTheStrategyThatMadeTheMesh) {
  HeldRevision held;
  held.revision.report.taken = {"local, 6 edge lengths", "", 0.75};
  const auto taken = encode_report(held).diagnostics().taken();
  EXPECT_EQ(taken.strategy(), "local, 6 edge lengths");
  EXPECT_EQ(taken.reason(), "");
  EXPECT_EQ(taken.seconds(), 0.75);
}

}  // namespace
}  // namespace remeshd
