#include "server/session/stored_form.h"

#include <gtest/gtest.h>

namespace remeshd {
namespace {

Report report() {
  Report r;
  r.seconds = {.setup = 1, .optimise = 2, .total = 7};
  r.attempts = {{"local, 4 edge lengths", "too small", 0.25}, {"full", "a facet is missing", 0.5}};
  r.taken = {"fresh", "", 0.75};
  r.geometry_seconds = 0.125;
  r.geometry_attempts = {{"swept", "no common axis", 0.0625}};
  return r;
}

TEST(StoredSeconds, OfTheRunAndItsAttemptsComeBackFromTheRecord) {
  HeldRevision held;
  held.record.seconds = seconds_of(report());
  held.revision.report.attempts = {{"local, 4 edge lengths", "too small"},
                                   {"full", "a facet is missing"}};
  held.revision.report.geometry_attempts = {{"swept", "no common axis"}};
  tell_seconds(held);
  const Report& told = held.revision.report;
  EXPECT_EQ(told.seconds.setup, 1);
  EXPECT_EQ(told.seconds.optimise, 2);
  EXPECT_EQ(told.seconds.total, 7);
  EXPECT_EQ(told.attempts[0].seconds, 0.25);
  EXPECT_EQ(told.attempts[1].seconds, 0.5);
  EXPECT_EQ(told.taken.seconds, 0.75);
  EXPECT_EQ(told.geometry_seconds, 0.125);
  EXPECT_EQ(told.geometry_attempts[0].seconds, 0.0625);
}

TEST(StoredSeconds, OfARecordThatHasNoneOfAttemptsAreThoseOfTheRun) {
  HeldRevision held;
  held.record.seconds = seconds_of(report());
  held.record.seconds.resize(7);  // a record of before keeps those of the phases
  held.revision.report.attempts = {{"full", "a facet is missing"}};
  tell_seconds(held);
  EXPECT_EQ(held.revision.report.seconds.total, 7);
  EXPECT_EQ(held.revision.report.attempts[0].seconds, 0);
}

}  // namespace
}  // namespace remeshd
