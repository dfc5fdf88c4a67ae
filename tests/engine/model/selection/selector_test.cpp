#include "engine/model/selection/selector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/support/expect_error.h"

namespace remeshd {
namespace {

bool names(const std::string& selector, const std::string& feature, const std::string& face) {
  return std::ranges::any_of(read_selector(selector, "sizes.a.on"),
                             [&](const SelectorTerm& t) { return t.names(feature, face); });
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
  EXPECT_TRUE(read_selector("rib", "").at(0).names("rib"));
  EXPECT_FALSE(read_selector("rib.*", "").at(0).names("rib"));
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
  const std::string selector = "hole*.wall | rib|plate.top ";
  EXPECT_EQ(read_selector(selector, "").size(), 3U);
  EXPECT_TRUE(names(selector, "hole2", "wall"));
  EXPECT_TRUE(names(selector, "rib", "bottom"));
  EXPECT_TRUE(names(selector, "plate", "top"));
  EXPECT_FALSE(names(selector, "plate", "bottom"));
}

TEST(Selector, ATermMayHaveACondition) {
  const auto terms = read_selector("plate.top & z > 10 && (x<1 || y<2) | rib|hole*&nz==1", "");
  ASSERT_EQ(terms.size(), 3U);
  EXPECT_EQ(terms[0].glob, "plate.top");
  EXPECT_EQ(terms[0].condition, "z > 10 && (x<1 || y<2)");
  EXPECT_EQ(terms[1].glob, "rib");
  EXPECT_EQ(terms[1].condition, "");
  EXPECT_EQ(terms[2].glob, "hole*");
  EXPECT_EQ(terms[2].condition, "nz==1");
}

TEST(Selector, ThatCannotBeReadIsAnErrorAtItsPlace) {
  for (const std::string text : {"", " ", "a |", "| a", "a || b", "a b", "a-b", "a.\xC3\xA4", "a\n",
                                 "a &", "& z > 1", "a && z > 1", "a & | b"})
    EXPECT_EQ(test::place_of(test::error_of([&] { read_selector(text, "sizes.a.on"); })),
              "SELECTOR_INVALID - sizes.a.on")
        << text;
}

TEST(Selector, HasNoTermLongerThanANameAndNotTooMany) {
  const auto refused = [](const std::string& text) {
    return test::error_of([&] { read_selector(text, "sizes.a.on"); }).reason;
  };
  EXPECT_EQ(refused(std::string(kSelectorLimits.term_length + 1, 'a')), "SELECTOR_INVALID");
  EXPECT_NO_THROW(read_selector(std::string(kSelectorLimits.term_length, 'a'), ""));
  std::string many = "a";
  for (std::size_t k = 1; k < kSelectorLimits.terms; ++k) many += "|a";
  EXPECT_NO_THROW(read_selector(many, ""));
  EXPECT_EQ(refused(many + "|a"), "SELECTOR_INVALID");
}

}  // namespace
}  // namespace remeshd
