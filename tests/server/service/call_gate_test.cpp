#include "server/service/call_gate.h"

#include <gtest/gtest.h>

#include <thread>

#include "engine/base/error.h"

namespace remeshd::test {
namespace {

using namespace std::chrono_literals;

TEST(CallGates, LetNobodyInOnceClosed) {
  CallGate gate;
  EXPECT_TRUE(gate.enter());
  gate.close();
  EXPECT_TRUE(gate.closed());
  try {
    static_cast<void>(gate.enter());
    FAIL() << "let in";
  } catch (const Error& why) {
    EXPECT_EQ(why.info().reason, "SHUTTING_DOWN");
    EXPECT_TRUE(why.info().retry_after);
  }
}

TEST(CallGates, WaitForThoseInside) {
  CallGate gate;
  EXPECT_TRUE(gate.wait_until_empty(0s));
  CallGate::Pass pass = gate.enter();
  const CallGate::Pass copy = pass;
  gate.close();
  EXPECT_FALSE(gate.wait_until_empty(1ms));
  pass.reset();
  EXPECT_FALSE(gate.wait_until_empty(1ms));
  std::thread other([held = copy]() mutable { held.reset(); });
  other.join();
  EXPECT_FALSE(gate.wait_until_empty(1ms));
}

TEST(CallGates, AreEmptyWhenTheLastOneLeaves) {
  CallGate gate;
  std::thread other([pass = gate.enter()]() mutable {
    std::this_thread::sleep_for(1ms);
    pass.reset();
  });
  EXPECT_TRUE(gate.wait_until_empty(10s));
  other.join();
}

TEST(CallGates, MayGoBeforeThoseInside) {
  CallGate::Pass pass;
  {
    CallGate gate;
    pass = gate.enter();
  }
  pass.reset();
}

}  // namespace
}  // namespace remeshd::test
