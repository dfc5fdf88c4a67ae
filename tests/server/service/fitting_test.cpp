#include "server/service/fitting.h"

#include <gtest/gtest.h>

namespace remeshd {
namespace {

TEST(Fitting, LeavesWhatFits) {
  EXPECT_EQ(fitting("", 8), "");
  EXPECT_EQ(fitting("12345678", 8), "12345678");
  EXPECT_EQ(fitting("\xE2\x82\xAC", 3), "\xE2\x82\xAC");
}

TEST(Fitting, CutsBetweenCharactersAndKeepsTheLimit) {
  EXPECT_EQ(fitting("123456789", 8), "12345...");
  EXPECT_EQ(fitting("1234\xE2\x82\xAC\xE2\x82\xAC", 8), "1234...");
  EXPECT_EQ(fitting("123456789", 3), "...");
}

TEST(Fitting, ReplacesWhatIsNoUtf8) {
  EXPECT_EQ(fitting("a\xFF"
                    "b\xC3",
                    8),
            "a?b?");
  EXPECT_EQ(fitting("\xED\xA0\x80", 8), "???");       // a surrogate
  EXPECT_EQ(fitting("\xE0\x80\x80", 8), "???");       // longer than need be
  EXPECT_EQ(fitting("\xF4\x90\x80\x80", 8), "????");  // beyond U+10FFFF
}

}  // namespace
}  // namespace remeshd
