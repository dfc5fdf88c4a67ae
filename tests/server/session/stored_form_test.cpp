#include "server/session/stored_form.h"

#include <gtest/gtest.h>

namespace remeshd {
namespace {

Report report() {
  Report r;
  r.seconds = {.setup = 1, .optimise = 2, .total = 7};
  r.attempts = {{"local, 4 edge lengths", "too small", 0.25}, {"full", "a facet is missing", 0.5}};
  return r;
}

TEST(StoredSeconds, OfTheRunAndItsAttemptsComeBackFromTheRecord) {
  HeldRevision held;
  held.record.seconds = seconds_of(report());
  held.revision.report.attempts = {{"local, 4 edge lengths", "too small"},
                                   {"full", "a facet is missing"}};
  tell_seconds(held);
  const Report& told = held.revision.report;
  EXPECT_EQ(told.seconds.setup, 1);
  EXPECT_EQ(told.seconds.optimise, 2);
  EXPECT_EQ(told.seconds.total, 7);
  EXPECT_EQ(told.attempts[0].seconds, 0.25);
  EXPECT_EQ(told.attempts[1].seconds, 0.5);
}

TEST(StoredSeconds, OfARecordThatHasNoneOfAttemptsAreThoseOfTheRun) {
  Report before = report();
  before.attempts.clear();
  HeldRevision held;
  held.record.seconds = seconds_of(before);
  held.revision.report.attempts = {{"full", "a facet is missing"}};
  tell_seconds(held);
  EXPECT_EQ(held.revision.report.seconds.total, 7);
  EXPECT_EQ(held.revision.report.attempts[0].seconds, 0);
}

}  // namespace
}  // namespace remeshd
