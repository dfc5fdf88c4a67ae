#include "engine/local_fuse/gave_up.h"

#include <gtest/gtest.h>

#include <memory>
#include <type_traits>

namespace remeshd {
namespace {

constexpr GaveUp kTooMany{"slabs", "there are too many"};

Tried<int> half(int n) {
  if (n % 2 != 0) return GaveUp{"halves", "the number is odd"};
  return n / 2;
}

TEST(TriedTest, AValueIsThereAndCanBeChanged) {
  Tried<std::string> tried = std::string("abc");
  ASSERT_TRUE(tried);
  EXPECT_EQ(*tried, "abc");
  EXPECT_EQ(tried->size(), 3U);
  *tried += "d";
  EXPECT_EQ(*std::as_const(tried), "abcd");
  EXPECT_EQ(std::as_const(tried)->size(), 4U);
}

TEST(TriedTest, WhatWasGivenUpHasAReason) {
  const Tried<std::string> tried = kTooMany;
  ASSERT_FALSE(tried);
  EXPECT_EQ(text_of(tried.why()), "slabs: there are too many");
}

TEST(TriedTest, AReasonPassesOnToAnotherType) {
  const auto text = [](int n) -> Tried<std::string> {
    const Tried<int> number = half(n);
    if (!number) return number.why();
    return std::to_string(*number);
  };
  EXPECT_EQ(*text(8), "4");
  EXPECT_EQ(text_of(text(7).why()), "halves: the number is odd");
}

TEST(TriedTest, AValueThatCannotBeCopiedIsMoved) {
  Tried<std::unique_ptr<int>> tried = std::make_unique<int>(5);
  const std::unique_ptr<int> taken = *std::move(tried);
  EXPECT_EQ(*taken, 5);
}

TEST(TriedTest, AFalseValueIsAValue) {
  EXPECT_TRUE(Tried<bool>(false));
  EXPECT_TRUE(Tried<int>(0));
}

TEST(TriedTest, NothingIsBoolUnlessAsked) {
  static_assert(!std::is_convertible_v<Tried<int>, bool>);
  static_assert(!std::is_convertible_v<Tried<void>, bool>);
}

TEST(TriedTest, WithoutAValueItIsDoneOrHasAReason) {
  const Tried<void> done, not_done = kTooMany;
  EXPECT_TRUE(done);
  ASSERT_FALSE(not_done);
  EXPECT_EQ(text_of(not_done.why()), "slabs: there are too many");
}

}  // namespace
}  // namespace remeshd
