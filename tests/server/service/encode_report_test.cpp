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
  held.revision.report.geometry = "swept";
  EXPECT_EQ(encode_report(held).diagnostics().geometry(), "swept");
}

}  // namespace
}  // namespace remeshd
