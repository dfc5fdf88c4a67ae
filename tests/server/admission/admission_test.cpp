#include "server/admission/admission.h"

#include <gtest/gtest.h>

#include <future>
#include <vector>

#include "tests/support/expect_error.h"

namespace remeshd {
namespace {

const auto kNoRefusal = [](const Error& error) { ADD_FAILURE() << error.what(); };

TEST(Admission, LetsInAsManyAsThereIsRoomFor) {
  Pool pool({.workers = 1, .queue = 3});
  Admission admission(pool);
  constexpr std::size_t kSpare = 4, kRoom = 4;
  std::vector<Admission::TicketPtr> tickets;
  for (std::size_t i = 0; i < kRoom + kSpare; ++i) tickets.push_back(admission.admit(""));
  const ErrorInfo error = test::error_of([&] { admission.admit(""); });
  EXPECT_EQ(error.reason, "BUSY");
  EXPECT_GT(error.retry_after, 0);
}

TEST(Admission, ATicketThatIsGivenBackIsFreeAgain) {
  Pool pool({.workers = 1, .queue = 0});
  Admission admission(pool);
  for (int i = 0; i < 1000; ++i) EXPECT_TRUE(admission.admit(""));
}

TEST(Admission, AFullQueueLeavesAFewPlacesForWhatMayBeThereAlready) {
  Pool pool({.workers = 1, .queue = 0});
  Admission admission(pool);
  std::promise<void> started, end;
  pool.submit({.run =
                   [&] {
                     started.set_value();
                     end.get_future().wait();
                   },
               .refused = kNoRefusal});
  started.get_future().wait();
  int admitted = 0;
  for (int i = 0; i < 1000; ++i) {
    try {
      admission.admit("");
      ++admitted;
    } catch (const Error& error) {
      EXPECT_EQ(error.info().reason, "BUSY");
    }
  }
  EXPECT_GE(admitted, 4);
  EXPECT_LE(admitted, 50);  // four, and five a second
  end.set_value();
}

TEST(Admission, OfAPoolThatHasEndedSaysSo) {
  Pool pool({.workers = 1, .queue = 10});
  Admission admission(pool);
  pool.shutdown();
  std::vector<Admission::TicketPtr> spare;
  const ErrorInfo error = test::error_of([&] {
    for (int i = 0; i < 100; ++i) spare.push_back(admission.admit(""));
  });
  EXPECT_EQ(error.reason, "SHUTTING_DOWN");
}

}  // namespace
}  // namespace remeshd
