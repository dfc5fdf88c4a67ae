#include "server/session/head_decision.h"

#include <gtest/gtest.h>

namespace remeshd {
namespace {

std::string text(const HeadDecision& decision) {
  return std::string(decision.move ? "moves" : "stays") + (decision.conflict ? " conflict" : "") +
         (decision.kept ? " kept" : "");
}

/// An edit of `base` that is new to a design whose head is `head`.
std::string edit(const HeadRule& rule, const std::string& head, bool is_new = true) {
  return text(decide_head(rule, {.id = "made", .head = head, .is_new = is_new}));
}
std::string first_decision(const HeadRule& rule, bool is_new, bool same_model) {
  return text(decide_head(rule, {.id = "made",
                                 .head = "head",
                                 .is_new = is_new,
                                 .first_mesh = true,
                                 .same_model = same_model}));
}

TEST(HeadDecision, AnEditMovesTheHeadWhileItIsItsBase) {
  EXPECT_EQ(edit({.expected = "base"}, "base"), "moves");
  EXPECT_EQ(edit({.expected = "base"}, "base", false), "moves");
  EXPECT_EQ(edit({.expected = "base"}, "other"), "stays conflict");
}

TEST(HeadDecision, WhatIsTheHeadAlreadyIsNoConflict) {
  EXPECT_EQ(edit({.expected = "base", .require = true}, "made", false), "stays");
}

TEST(HeadDecision, ADesignWithoutAHeadGetsOne) {
  EXPECT_EQ(edit({.expected = "base"}, ""), "moves");
  EXPECT_EQ(edit({.advance = false, .expected = "base"}, ""), "moves");
  EXPECT_EQ(edit({.advance = false, .never = true}, ""), "stays");
}

TEST(HeadDecision, WithoutAdvanceOnlyARequiredHeadConflicts) {
  EXPECT_EQ(edit({.advance = false, .expected = "base"}, "base"), "stays");
  EXPECT_EQ(edit({.advance = false, .expected = "base"}, "other"), "stays");
  EXPECT_EQ(edit({.advance = false, .expected = "base", .require = true}, "other"),
            "stays conflict");
}

TEST(HeadDecision, AFirstMeshMovesItUnaskedOnlyIfItIsNewAndOfTheSameModel) {
  EXPECT_EQ(first_decision({}, true, true), "moves");
  EXPECT_EQ(first_decision({}, false, true), "stays");
  EXPECT_EQ(first_decision({}, true, false), "stays kept");
  EXPECT_EQ(first_decision({}, false, false), "stays kept");
}

TEST(HeadDecision, AFirstMeshMovesItWhereItIsAsked) {
  for (const bool is_new : {false, true})
    for (const bool same_model : {false, true}) {
      EXPECT_EQ(first_decision({.advance = true}, is_new, same_model), "moves");
      EXPECT_EQ(first_decision({.advance = true, .expected = "other"}, is_new, same_model),
                "stays conflict");
      EXPECT_EQ(first_decision({.advance = false}, is_new, same_model), "stays");
    }
}

}  // namespace
}  // namespace remeshd
