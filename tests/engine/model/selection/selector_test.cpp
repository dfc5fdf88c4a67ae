#include "engine/model/selection/selector.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/expect_error.h"

namespace remeshd {
namespace {

bool names(const std::string& selector, const std::string& feature, const std::string& face) {
  return Selector(selector, "sizes.a.on").names(feature, face);
}

TEST(Selector, NamesAFaceByFeatureAndFace) {
  EXPECT_TRUE(names("hole1.wall", "hole1", "wall"));
  EXPECT_FALSE(names("hole1.wall", "hole1", "top"));
  EXPECT_FALSE(names("hole1.wall", "hole11", "wall"));
  EXPECT_FALSE(names("wall", "hole1", "wall"));
}

TEST(Selector, NamesAllFacesOfAFeature) {
  EXPECT_TRUE(names("rib", "rib", "side3"));
  EXPECT_FALSE(names("rib", "rib2", "side3"));
  EXPECT_TRUE(Selector("rib", "").names("rib"));
  EXPECT_FALSE(Selector("rib.*", "").names("rib"));
}

TEST(Selector, AStarStandsForAnyCharactersAndAQuestionMarkForAnyOne) {
  EXPECT_TRUE(names("hole*.wall", "hole", "wall"));
  EXPECT_TRUE(names("hole*.wall", "hole12", "wall"));
  EXPECT_FALSE(names("hole*.wall", "hole12", "bottom"));
  EXPECT_TRUE(names("hole?.wall", "hole1", "wall"));
  EXPECT_FALSE(names("hole?.wall", "hole", "wall"));
  EXPECT_FALSE(names("hole?.wall", "hole12", "wall"));
  EXPECT_TRUE(names("*", "any", "face"));
  EXPECT_TRUE(names("*.top", "any", "top"));
  EXPECT_TRUE(names("*a*b.*c*", "xaxbabb", "cc"));
  EXPECT_FALSE(names("*a*b.*c", "xaxbab", "cd"));
}

TEST(Selector, TermsStandSideBySide) {
  const Selector selector("hole*.wall | rib|plate.top ", "");
  EXPECT_EQ(selector.terms(), 3U);
  EXPECT_TRUE(selector.names("hole2", "wall"));
  EXPECT_TRUE(selector.names("rib", "bottom"));
  EXPECT_TRUE(selector.names("plate", "top"));
  EXPECT_FALSE(selector.names("plate", "bottom"));
}

TEST(Selector, ThatCannotBeReadIsAnErrorAtItsPlace) {
  for (const std::string text :
       {"", " ", "a |", "| a", "a || b", "a b", "a-b", "a.\xC3\xA4", "a\n"})
    EXPECT_EQ(test::place_of(test::error_of([&] { Selector(text, "sizes.a.on"); })),
              "SELECTOR_INVALID - sizes.a.on")
        << text;
}

TEST(Selector, HasNoTermLongerThanANameAndNotTooMany) {
  const auto refused = [](const std::string& text) {
    return test::error_of([&] { Selector(text, "sizes.a.on"); }).reason;
  };
  EXPECT_EQ(refused(std::string(kSelectorLimits.term_length + 1, 'a')), "SELECTOR_INVALID");
  EXPECT_NO_THROW(Selector(std::string(kSelectorLimits.term_length, 'a'), ""));
  std::string many = "a";
  for (std::size_t k = 1; k < kSelectorLimits.terms; ++k) many += "|a";
  EXPECT_NO_THROW(Selector(many, ""));
  EXPECT_EQ(refused(many + "|a"), "SELECTOR_INVALID");
}

TEST(Selector, AConditionIsRefusedByName) {
  const ErrorInfo info = test::error_of([] { Selector("plate.top & z > 10", "sizes.a.on"); });
  EXPECT_EQ(test::place_of(info), "UNSUPPORTED - sizes.a.on");
  EXPECT_NE(info.message.find("condition"), std::string::npos);
}

}  // namespace
}  // namespace remeshd
