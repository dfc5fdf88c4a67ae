#include "server/admission/freed_memory.h"

#include <gtest/gtest.h>

#include "server/limits.h"

namespace remeshd {
namespace {

TEST(FreedMemory, IsGivenBackOnceTheProcessHasGrownAndNotBefore) {
  std::uint64_t resident = 10 * limits::kReturnGrowth;
  int given_back = 0;
  FreedMemory memory({.resident = [&] { return resident; },
                      .return_freed_memory =
                          [&] {
                            ++given_back;
                            resident -= limits::kReturnGrowth / 2;
                          }});
  memory.look();
  EXPECT_EQ(given_back, 1);
  resident += limits::kReturnGrowth - 1;
  memory.look();
  EXPECT_EQ(given_back, 1);
  resident += 1;
  memory.look();
  EXPECT_EQ(given_back, 2);
  memory.look();
  EXPECT_EQ(given_back, 2);
}

}  // namespace
}  // namespace remeshd
