#include "client/cli/with_edit.h"

#include <gmock/gmock.h>

#include "client/cli/model_changes.h"
#include "proto/document.h"

namespace remeshd::cli {
namespace {

TEST(WithEdit, IsTheModelThatTheEditMakes) {
  const auto model = parse_model(R"({"name": "plate", "parameters": {"wall": 7},
    "features": [
      {"id": "base", "type": "block", "nature": "ADDITIVE",
       "parameters": {"dx": 40, "dy": 40, "dz": "wall"}},
      {"id": "hole", "type": "cylinder", "nature": "SUBTRACTIVE",
       "parameters": {"radius": 8, "height": 20}},
      {"id": "rib", "type": "block", "nature": "ADDITIVE",
       "parameters": {"dx": 1, "dy": 1, "dz": 9}}],
    "sizes": [{"id": "rim", "on": "hole.wall", "size": "radius/8"},
              {"id": "old", "on": "base.top", "size": 1}],
    "groups": {"load": "base.top", "held": "base.bottom"}})");
  const auto edit = parse_edit(R"({"edits": [
    {"setParameter": {"name": "wall", "value": 8}},
    {"setFeatureParameter": {"feature": "hole", "name": "radius", "value": 9}},
    {"setPlacement": {"feature": "base", "placement": {"origin": [1, 0, 0]}}},
    {"addFeature": {"after": "base", "feature": {"id": "drill", "type": "cylinder",
     "nature": "SUBTRACTIVE", "parameters": {"radius": 1, "height": 20}}}},
    {"removeFeature": {"feature": "rib"}},
    {"setSize": {"id": "rim", "in": {"ball": [0, 0, 0, 9]}}},
    {"setSize": {"id": "spot", "on": "drill.wall", "size": 0.5}},
    {"removeSize": {"id": "old"}},
    {"setGroup": {"name": "load", "on": "base.x_max"}},
    {"setGroup": {"name": "all", "on": "base"}},
    {"removeGroup": {"name": "held"}}]})");
  const auto edited = with_edit(model, edit);
  EXPECT_THAT(
      model_changes(model, edited),
      testing::ElementsAre("wall 7 -> 8", "base moved", "+ drill", "hole.radius 8 -> 9", "- rib",
                           "size rim at another place", "+ size spot", "- size old",
                           "group load changed", "+ group all", "- group held"));
  EXPECT_EQ(edited.features(1).id(), "drill");
  EXPECT_EQ(edited.sizes(0).size().string_value(), "radius/8");
}

}  // namespace
}  // namespace remeshd::cli
