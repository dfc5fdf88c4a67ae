#include "server/tier/breaker.h"

#include <gtest/gtest.h>

#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "server/limits.h"
#include "tests/server/tier/shelf.h"
#include "tests/support/expect_error.h"

namespace remeshd::test {
namespace {

class BreakerTest : public testing::Test {
 protected:
  std::unique_ptr<Shelf> owned_ = std::make_unique<Shelf>();
  Shelf& shelf_ = *owned_;
  Breaker::Clock::time_point now_;
  std::vector<std::string> told_;
  Breaker breaker_{std::move(owned_), [this](const std::string& why) { told_.push_back(why); },
                   [this] { return now_; }};

  bool ask() {
    try {
      static_cast<void>(breaker_.get("key", {}));
      return true;
    } catch (const Error& failure) {
      EXPECT_EQ(failure.info().reason, "TIER_UNAVAILABLE");
      EXPECT_EQ(failure.info().kind, ErrorKind::Unavailable);
      EXPECT_GT(failure.info().retry_after.value_or(0), 0);
      return false;
    }
  }
};

TEST_F(BreakerTest, LeavesAStoreAloneThatFails) {
  shelf_.fails = true;
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(ask());
  EXPECT_EQ(shelf_.asked, 3);
  now_ += limits::kTierRest / 2;
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(ask());
  EXPECT_EQ(shelf_.asked, 3) << "it was not asked again";
  EXPECT_EQ(told_.size(), 1U);
}

TEST_F(BreakerTest, TriesItAgainOnce) {
  shelf_.fails = true;
  for (int i = 0; i < 3; ++i) ask();
  now_ += limits::kTierRest;
  EXPECT_FALSE(ask());
  EXPECT_FALSE(ask());
  EXPECT_EQ(shelf_.asked, 4);
  now_ += limits::kTierRest;
  shelf_.fails = false;
  EXPECT_TRUE(ask());
  EXPECT_TRUE(ask());
  EXPECT_EQ(told_.size(), 2U);
  EXPECT_EQ(told_.back(), "");
}

TEST_F(BreakerTest, TakesAFailureNowAndThen) {
  for (int i = 0; i < 10; ++i) {
    shelf_.fails = i % 3 < 2;
    EXPECT_EQ(ask(), !shelf_.fails);
  }
  EXPECT_EQ(shelf_.asked, 10);
  EXPECT_TRUE(told_.empty());
}

TEST_F(BreakerTest, TakesNoLookUpThatHasTooLittleTimeForAFailure) {
  const auto look_up = [&](double within) {
    EXPECT_EQ(error_of([&] { static_cast<void>(breaker_.has("key", within)); }).reason,
              "TIER_UNAVAILABLE");
  };
  shelf_.times_out = true;
  for (int i = 0; i < 10; ++i) look_up(limits::kTierLookUp);
  EXPECT_EQ(shelf_.asked, 10);
  EXPECT_TRUE(told_.empty());
  for (int i = 0; i < 10; ++i) look_up(limits::kTierAnswer);
  EXPECT_EQ(shelf_.asked, 13) << "one that had the time fails";
  EXPECT_EQ(told_.size(), 1U);
}

TEST_F(BreakerTest, IsNotLeftAloneForLongerByALookUpThatHasTooLittleTime) {
  shelf_.fails = true;
  for (int i = 0; i < 3; ++i) ask();
  shelf_.fails = false;
  shelf_.times_out = true;
  now_ += limits::kTierRest;
  EXPECT_EQ(error_of([&] { static_cast<void>(breaker_.has("key", limits::kTierLookUp)); }).reason,
            "TIER_UNAVAILABLE");
  EXPECT_EQ(shelf_.asked, 4);
  shelf_.times_out = false;
  EXPECT_TRUE(ask());
  EXPECT_EQ(shelf_.asked, 5);
}

TEST_F(BreakerTest, DoesNotTakeAMissForAFailure) {
  for (int i = 0; i < 10; ++i) EXPECT_EQ(breaker_.get("key", {}), std::nullopt);
  breaker_.put("key", "bytes");
  EXPECT_EQ(breaker_.get("key", {}), "bytes");
  EXPECT_TRUE(breaker_.has("key", 1));
}

TEST_F(BreakerTest, WhatIsCancelledTellsNothingOfTheStore) {
  shelf_.get_hangs = true;
  std::stop_source stop;
  stop.request_stop();
  for (int i = 0; i < 10; ++i)
    EXPECT_EQ(error_of([&] { static_cast<void>(breaker_.get("key", stop.get_token())); }).kind,
              ErrorKind::Cancelled);
  EXPECT_TRUE(told_.empty());
}

}  // namespace
}  // namespace remeshd::test
