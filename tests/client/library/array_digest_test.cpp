#include "client/library/array_digest.h"

#include <gtest/gtest.h>

namespace remeshd::client {
namespace {

// Worked out with Python's hashlib.

TEST(ArrayDigest, OfAnEmptyArrayIsTheSumOverNothing) {
  EXPECT_EQ(array_digest(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(ArrayDigest, OfAShortArrayIsTheSumOfOneSum) {
  EXPECT_EQ(array_digest("abc"),
            "4f8b42c22dd3729b519ba6f68d2da7cc5b2d606d05daed5ad5128cc03e6c6358");
}

TEST(ArrayDigest, OfAWholeBlockHasNoEmptyBlockBehindIt) {
  EXPECT_EQ(array_digest(std::string(16384, 'x')),
            "754d0f7ef728db5ef264b6597236275cf2234473fe9fd91fa72f16723291ca10");
}

TEST(ArrayDigest, OfTwoBlocksAndAByteIsTheSumOfThree) {
  EXPECT_EQ(array_digest(std::string(32769, 'x')),
            "3ee546b0d0653091e38957ce3773fc41a56b6042eb724917e0039b35102ee4d4");
}

}  // namespace
}  // namespace remeshd::client
