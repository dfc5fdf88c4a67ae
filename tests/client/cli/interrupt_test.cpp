#include "client/cli/interrupt.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "client/cli/exit_code.h"

namespace remeshd::cli {
namespace {

/// Within 10 s.
bool is_told_to_stop(const Interrupt& interrupt) {
  for (int k = 0; k < 1000 && !interrupt.token().stop_requested(); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return interrupt.token().stop_requested();
}

/// Ends the process with 0 where it was told to stop.
[[noreturn]] void send(int signal) {
  const Interrupt interrupt;
  ::kill(::getpid(), signal);
  std::_Exit(is_told_to_stop(interrupt) ? 0 : 1);
}

[[noreturn]] void send_two() {
  const Interrupt interrupt;
  ::kill(::getpid(), SIGINT);
  if (!is_told_to_stop(interrupt)) std::_Exit(1);
  ::kill(::getpid(), SIGTERM);
  std::this_thread::sleep_for(std::chrono::seconds(10));
  std::_Exit(1);
}

// Each in a process of its own, for signals are a matter of all its threads.
class InterruptDeathTest : public testing::Test {
 protected:
  InterruptDeathTest() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(InterruptDeathTest, AsksToStopAtTheFirstSignal) {
  EXPECT_EXIT(send(SIGINT), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(send(SIGTERM), testing::ExitedWithCode(0), "");
}

TEST_F(InterruptDeathTest, EndsTheProcessAtTheSecondSignal) {
  EXPECT_EXIT(send_two(), testing::ExitedWithCode(kInterrupted), "");
}

}  // namespace
}  // namespace remeshd::cli
