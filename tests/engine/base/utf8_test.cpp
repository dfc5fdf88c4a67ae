#include "engine/base/utf8.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace remeshd {
namespace {

TEST(Utf8, HasTheFirstAndTheLastCharacterOfEachLength) {
  for (const char* text : {"\x01", "\x7F", "\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF",
                           "\xEE\x80\x80", "\xEF\xBF\xBF", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"})
    EXPECT_EQ(utf8_length(text, 0), std::string_view(text).size()) << text;
  EXPECT_TRUE(is_utf8("5 \u00B5m at 20 \u00B0C, \u2300 3 \U0001F529"));
}

TEST(Utf8, HasNoCharacterInMoreBytesThanNeedBeNorSurrogatesNorHalfOfOne) {
  for (const char* text : {"\x80", "\xC1\xBF", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xF0\x8F\xBF\xBF",
                           "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xC2", "\xE2\x82", "\xC2z"})
    EXPECT_FALSE(is_utf8("a" + std::string(text))) << text;
}

}  // namespace
}  // namespace remeshd
