#include "proto/place_in_document.h"

#include <gtest/gtest.h>

#include <string>

namespace remeshd {
namespace {

const char* const kModel = R"({"name": "plate",
 "parameters": {"wall": 4, "depth": {"value": 2, "lower": 1}},
 "features": [
  {"id": "base", "nature": "ADDITIVE", "type": "block",
   "parameters": {"dx": 80, "dy": "wall / 0"},
   "placement": {"origin": [0, "x y", 0], "z_axis": [0, 0, 0]}},
  {"id": "rib", "nature": "ADDITIVE", "type": "prism",
   "parameters": {"height": 1, "profile": [[0, 0],
     {"through": [1, 1], "to": ["a", 2]}]}}]})";

const char* const kEdit = R"({"edits": [
  {"setParameter": {"name": "wall", "value": -1}},
  {"setFeatureParameter": {"feature": "base", "name": "dx", "value": 0}},
  {"setParameter": {"name": "wall", "value": -2}},
  {"setPlacement": {"feature": "rib", "placement": {"origin": [0, 0, "q"]}}},
  {"addFeature": {"feature": {"id": "pin", "nature": "ADDITIVE", "type": "cylinder",
    "parameters": {"radius": -3, "height": 1}}}},
  {"removeFeature": {"feature": "gone"}}]})";

/// `line:column`, `-` for none.
std::string place(const char* text, const ValueAtFault& what) {
  const TextPosition at = place_in_document(text, what);
  if (at.line == 0) return "-";
  return std::to_string(at.line) + ":" + std::to_string(at.column);
}

TEST(PlaceInAModel, OfAParameterIsItsValueInTheShortFormAndTheLongOne) {
  EXPECT_EQ(place(kModel, {.feature = "", .parameter = "wall"}), "2:25");
  EXPECT_EQ(place(kModel, {.feature = "", .parameter = "depth"}), "2:37");
}

TEST(PlaceInAModel, OfAFeaturesParameterIsItsValue) {
  EXPECT_EQ(place(kModel, {.feature = "base", .parameter = "dy"}), "5:35");
  EXPECT_EQ(place(kModel, {.feature = "base", .parameter = "placement.origin"}), "6:28");
  EXPECT_EQ(place(kModel, {.feature = "base", .parameter = "placement.origin[1]"}), "6:32");
  EXPECT_EQ(place(kModel, {.feature = "base", .parameter = "placement.zAxis"}), "6:53");
  EXPECT_EQ(place(kModel, {.feature = "rib", .parameter = "profile[1]"}), "9:6");
  EXPECT_EQ(place(kModel, {.feature = "rib", .parameter = "profile[1].through"}), "9:18");
  EXPECT_EQ(place(kModel, {.feature = "rib", .parameter = "type"}), "7:47");
}

TEST(PlaceInAModel, OfWhatIsNotThereIsTheFeatureThatLacksIt) {
  EXPECT_EQ(place(kModel, {.feature = "base", .parameter = "dz"}), "4:3");
  EXPECT_EQ(place(kModel, {.feature = "base", .parameter = ""}), "4:3");
  EXPECT_EQ(place(kModel, {.feature = "rib", .parameter = "profile[7]"}), "8:43");
}

TEST(PlaceInAModel, OfASizeIsItsFieldOrTheSizeThatLacksIt) {
  const char* const model = R"({"features": [],
 "sizes": [{"id": "holes", "on": "hole*.wall", "size": "radius/4"},
  {"id": "spot", "in": {"ball": [0, 0, "q", 1]}, "size": 2}]})";
  EXPECT_EQ(place(model, {.feature = "", .parameter = "sizes.holes.on"}), "2:34");
  EXPECT_EQ(place(model, {.feature = "hole1", .parameter = "sizes.holes.size"}), "2:56");
  EXPECT_EQ(place(model, {.feature = "", .parameter = "sizes.spot.in.ball[2]"}), "3:40");
  EXPECT_EQ(place(model, {.feature = "", .parameter = "sizes.spot.on"}), "3:3");
  EXPECT_EQ(place(model, {.feature = "", .parameter = "sizes.gone.on"}), "-");
  const char* const edit = R"({"edits": [{"removeSize": {"id": "gone"}},
  {"setSize": {"id": "spot", "in": {"box": [0, 0, 0, 1, 1, 0]}}}]})";
  EXPECT_EQ(place(edit, {.feature = "", .parameter = "sizes.gone", .edit_index = 0}), "1:12");
  EXPECT_EQ(place(edit, {.feature = "", .parameter = "sizes.spot.in.box[5]"}), "2:60");
  EXPECT_EQ(place(edit, {.feature = "", .parameter = "sizes.holes.on"}), "-");
}

TEST(PlaceInAModel, IsNoneOfWhatItDoesNotTellOf) {
  EXPECT_EQ(place(kModel, {.feature = "hub", .parameter = "radius"}), "-");
  EXPECT_EQ(place(kModel, {.feature = "", .parameter = "nodes"}), "-");
  EXPECT_EQ(place(kModel, {.feature = "", .parameter = ""}), "-");
  EXPECT_EQ(place("no document", {.feature = "base", .parameter = "dx"}), "-");
  EXPECT_EQ(place("[]", {.feature = "base", .parameter = "dx"}), "-");
}

TEST(PlaceInAnEdit, IsWhereTheEditAtFaultSetsTheValue) {
  EXPECT_EQ(place(kEdit, {.feature = "", .parameter = "wall", .edit_index = 0}), "2:46");
  EXPECT_EQ(place(kEdit, {.feature = "base", .parameter = "dx", .edit_index = 1}), "3:70");
  EXPECT_EQ(place(kEdit, {.feature = "gone", .parameter = "", .edit_index = 5}), "8:3");
  EXPECT_EQ(place(kEdit, {.feature = "", .parameter = "", .edit_index = 9}), "-");
}

TEST(PlaceInAnEdit, IsTheLastThatSetsAValueWhereNoneIsNamed) {
  EXPECT_EQ(place(kEdit, {.feature = "", .parameter = "wall"}), "4:46");
  EXPECT_EQ(place(kEdit, {.feature = "base", .parameter = "dx"}), "3:70");
  EXPECT_EQ(place(kEdit, {.feature = "rib", .parameter = "placement.origin[2]"}), "5:70");
  EXPECT_EQ(place(kEdit, {.feature = "pin", .parameter = "radius"}), "7:30");
  EXPECT_EQ(place(kEdit, {.feature = "base", .parameter = "dy"}), "-") << "the base sets it";
}

}  // namespace
}  // namespace remeshd
