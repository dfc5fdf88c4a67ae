#include "client/cli/terminal.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdlib>

namespace remeshd::cli {
namespace {

TEST(Terminal, IsDrawnOnWhereItsKindIsKnownAndNotDumb) {
  const int master = ::posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(master, 0);
  EXPECT_TRUE(can_draw(master, "xterm"));
  EXPECT_FALSE(can_draw(master, "dumb"));
  EXPECT_FALSE(can_draw(master, nullptr));
  ::close(master);
}

TEST(Terminal, IsNoFileAndNoPipe) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  EXPECT_FALSE(can_draw(ends[1], "xterm"));
  for (const int end : ends) ::close(end);
}

}  // namespace
}  // namespace remeshd::cli
