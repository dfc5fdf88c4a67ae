#include "server/store/checked_line.h"

#include <gtest/gtest.h>

namespace remeshd {
namespace {

TEST(CheckedLine, GivesItsTextBack) {
  const std::string line = checked_line(R"({"a": 1})");
  EXPECT_EQ(line.back(), '\n');
  EXPECT_EQ(checked_text(line), R"({"a": 1})");
  EXPECT_EQ(checked_text(std::string_view(line).substr(0, line.size() - 1)), R"({"a": 1})");
}

TEST(CheckedLine, IsRefusedWithAnyBitChanged) {
  const std::string line = checked_line(R"({"number": 10})");
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    for (unsigned bit = 0; bit < 8; ++bit) {
      std::string damaged = line;
      damaged[i] = static_cast<char>(static_cast<unsigned char>(damaged[i]) ^ (1U << bit));
      EXPECT_FALSE(checked_text(damaged)) << damaged;
    }
}

TEST(CheckedLine, IsRefusedWhenCutOff) {
  const std::string line = checked_line("text");
  for (std::size_t size = 0; size + 1 < line.size(); ++size)
    EXPECT_FALSE(checked_text(std::string_view(line).substr(0, size))) << size;
}

}  // namespace
}  // namespace remeshd
