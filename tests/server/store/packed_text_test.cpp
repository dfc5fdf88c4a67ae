#include "server/store/packed_text.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

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

TEST(PackedText, ThatClaimsMoreThanItsBytesCanHoldTakesNoMemory) {
  // A frame of zstd: its mark, a length of four bytes, 2^30, and one block of one byte.
  const std::string frame("\x28\xB5\x2F\xFD\xA0\x00\x00\x00\x40\x0B\x00\x00x", 13);
  const auto most = [] {
    struct rusage usage {};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;  // KiB
  };
  const long before = most();
  EXPECT_THROW(unpacked(frame), Error);
  EXPECT_LT(most() - before, 100 * 1024);
  const std::string long_text(1 << 24, 'a');
  EXPECT_EQ(unpacked(packed(long_text)), long_text) << "that packs as densely as any";
}

}  // namespace
}  // namespace remeshd
