#include "server/session/mesh_options.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/base/error.h"

namespace remeshd {
namespace {

Sizing first_sizing(const SizingPatch& sizing) { return first_options({.sizing = sizing}).sizing; }

Sizing edited(const SizingPatch& sizing, const Sizing& base) {
  return edit_options({.sizing = sizing}, {.sizing = base}).sizing;
}

/// The option that is at fault.
std::string refused(const SizingPatch& sizing) {
  try {
    first_sizing(sizing);
  } catch (const Error& failure) {
    EXPECT_EQ(failure.info().reason, "OPTIONS_INVALID");
    return failure.info().parameter;
  }
  return "";
}

const Sizing kUneven{
    .even = false, .edges_per_circle = 20, .layers = 3, .min_size = 0.25, .growth = 1.5};

TEST(SizingOptions, OfAFirstMeshAreAllRulesUnlessItSaysOtherwise) {
  EXPECT_EQ(first_sizing({}), (Sizing{.even = false}));
  EXPECT_EQ(first_sizing({.edges_per_circle = 20}),
            (Sizing{.even = false, .edges_per_circle = 20}));
  EXPECT_EQ(first_sizing({.layers = 3}), (Sizing{.even = false, .layers = 3}));
  EXPECT_EQ(first_sizing({.min_size = 0.5}), (Sizing{.even = false, .min_size = 0.5}));
  EXPECT_EQ(first_sizing({.growth = 1.5}), (Sizing{.even = false, .growth = 1.5}));
  EXPECT_EQ(first_sizing({.even = true}), (Sizing{.even = true}));
}

TEST(SizingOptions, OfAnEditOfAnEvenMeshAreEvenUnlessItGivesARule) {
  EXPECT_EQ(edited({}, {.even = true}), (Sizing{.even = true}));
  EXPECT_EQ(edited({.layers = 3}, {.even = true}), (Sizing{.even = false, .layers = 3}));
  EXPECT_EQ(edited({.even = false}, {.even = true}), (Sizing{.even = false}));
}

TEST(SizingOptions, ThatSayEvenAreEvenWhateverTheRules) {
  EXPECT_TRUE(first_sizing({.even = true, .edges_per_circle = 20, .layers = 3}).even);
  EXPECT_TRUE(edited({.even = true, .growth = 1.5}, kUneven).even);
}

TEST(SizingOptions, OfAnEditAreItsBasesButForWhatItGives) {
  EXPECT_EQ(edited({}, kUneven), kUneven);
  Sizing expected = kUneven;
  expected.edges_per_circle = 0;
  EXPECT_EQ(edited({.edges_per_circle = 0}, kUneven), expected);
  expected = kUneven;
  expected.layers = 0;
  EXPECT_EQ(edited({.layers = 0}, kUneven), expected);
  expected = kUneven;
  expected.min_size = 0.125;
  EXPECT_EQ(edited({.min_size = 0.125}, kUneven), expected);
  expected = kUneven;
  expected.growth = 2;
  EXPECT_EQ(edited({.growth = 2}, kUneven), expected);
}

TEST(SizingOptions, OfAnEvenMeshAreTheSameWhateverItSaidBeside) {
  // Ids tell even meshes apart by nothing, and edits inherit these.
  EXPECT_EQ(first_sizing({.even = true, .edges_per_circle = 20}), first_sizing({.even = true}));
  EXPECT_EQ(edited({.even = true}, kUneven), first_sizing({.even = true}));
}

TEST(SizingOptions, OutOfRangeAreNamed) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const std::uint32_t edges : {1U, 2U, 361U, ~0U})
    EXPECT_EQ(refused({.edges_per_circle = edges}), "sizing.edges_per_circle") << edges;
  for (const std::uint32_t layers : {17U, ~0U})
    EXPECT_EQ(refused({.layers = layers}), "sizing.layers") << layers;
  for (const double size : {0.0, -1.0, HUGE_VAL, kNan})
    EXPECT_EQ(refused({.min_size = size}), "sizing.min_size") << size;
  for (const double growth : {1.0, 2.001, -1.5, HUGE_VAL, kNan})
    EXPECT_EQ(refused({.growth = growth}), "sizing.growth") << growth;
  EXPECT_EQ(refused({.even = true, .layers = 17}), "sizing.layers");
}

TEST(SizingOptions, MayBeAtTheEndsOfTheirRanges) {
  for (const std::uint32_t edges : {0U, 3U, 360U})
    EXPECT_EQ(first_sizing({.edges_per_circle = edges}).edges_per_circle, edges);
  for (const std::uint32_t layers : {0U, 16U})
    EXPECT_EQ(first_sizing({.layers = layers}).layers, layers);
  EXPECT_EQ(first_sizing({.growth = 2}).growth, 2);
}

}  // namespace
}  // namespace remeshd
