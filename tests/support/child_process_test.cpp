#include "tests/support/child_process.h"

#include <gmock/gmock.h>

#include <csignal>
#include <stdexcept>

namespace remeshd::test {
namespace {

ChildEnd shell(const std::string& script, double seconds = 20) {
  return run_child("sh", {"sh", "-c", script}, seconds);
}

TEST(RunChild, CollectsWhatIsWrittenAndHowItEnded) {
  const ChildEnd child = shell("echo out; echo err >&2; exit 3");
  EXPECT_EQ(child.output, "out\n");
  EXPECT_EQ(child.errors, "err\n");
  EXPECT_EQ(child.exit_code, 3);
  EXPECT_FALSE(child.well());
  EXPECT_EQ(child.how(), "exit code 3");
  EXPECT_TRUE(shell("true").well());
}

TEST(RunChild, TellsTheSignalThatEndedIt) {
  const ChildEnd child = shell("kill -SEGV $$");
  EXPECT_EQ(child.signal, SIGSEGV);
  EXPECT_FALSE(child.well());
}

TEST(RunChild, EndsOneThatHangs) {
  const ChildEnd child = shell("exec sleep 60", 0.2);
  EXPECT_TRUE(child.too_long);
  EXPECT_FALSE(child.well());
  EXPECT_EQ(child.how(), "killed after its time");
}

TEST(RunChild, CountsProcessorTimeAndMemory) {
  const ChildEnd child = shell("i=0; while [ $i -lt 100000 ]; do i=$((i+1)); done");
  EXPECT_GT(child.cpu_seconds, 0.005);
  EXPECT_GT(child.peak_bytes, 1e5);
  EXPECT_LT(shell("exec sleep 0.1").cpu_seconds, 0.09);
}

TEST(RunChild, ThrowsWhereThereIsNoSuchProgram) {
  EXPECT_THROW(run_child("no-such-program", {"no-such-program"}, 1), std::runtime_error);
}

}  // namespace
}  // namespace remeshd::test
