#include "server/store/packed_text.h"

#include <gtest/gtest.h>

#include "engine/base/error.h"

namespace remeshd {
namespace {

TEST(PackedText, ComesBack) {
  for (const std::string& text :
       {std::string(), std::string("a"), std::string("a\0b", 3), std::string(100000, 'x')})
    EXPECT_EQ(unpacked(packed(text)), text);
  EXPECT_LT(packed(std::string(100000, 'x')).size(), 100U);
}

TEST(PackedText, ThatIsDamagedIsAnError) {
  const std::string whole = packed(std::string(1000, 'x'));
  EXPECT_THROW(unpacked(""), Error);
  EXPECT_THROW(unpacked("no such thing"), Error);
  EXPECT_THROW(unpacked(whole.substr(0, whole.size() - 1)), Error);
}

TEST(Base64, IsThatOfTheStandardWithoutPadding) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg");
  EXPECT_EQ(base64("fo"), "Zm8");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg");
}

TEST(Base64, ComesBack) {
  std::string bytes;
  for (int i = 0; i < 300; ++i) {
    EXPECT_EQ(from_base64(base64(bytes)), bytes);
    bytes += static_cast<char>(i * 7);
  }
  EXPECT_THROW(from_base64("Zm9v!"), Error);
}

}  // namespace
}  // namespace remeshd
