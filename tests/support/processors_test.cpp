#include "tests/support/processors.h"

#include <gtest/gtest.h>

namespace remeshd::test {
namespace {

int processor_of_this_thread() {
  cpu_set_t set;
  CPU_ZERO(&set);
  EXPECT_EQ(::sched_getaffinity(0, sizeof set, &set), 0);
  EXPECT_EQ(CPU_COUNT(&set), 1);
  int processor = 0;
  while (processor < CPU_SETSIZE && !CPU_ISSET(processor, &set)) ++processor;
  return processor;
}

TEST(OnProcessor, CountsFromThoseOfTheProcessAlsoWithinAnother) {
  if (processors().size() < 2) GTEST_SKIP() << "there is one processor alone";
  const OnProcessor client(1);
  EXPECT_EQ(processor_of_this_thread(), processors()[1]);
  {
    const OnProcessor daemon(0);
    EXPECT_EQ(processor_of_this_thread(), processors()[0]);
  }
  EXPECT_EQ(processor_of_this_thread(), processors()[1]);
}

}  // namespace
}  // namespace remeshd::test
