#include "client/cli/model_changes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "proto/document.h"

namespace remeshd::cli {
namespace {

using remesh::v1::FeatureModel;
using testing::ElementsAre;
using testing::IsEmpty;

FeatureModel plate() {
  return parse_model(R"({"name": "plate", "unit": "mm",
    "parameters": {"wall": 7, "depth": "wall / 2"},
    "features": [
      {"id": "base", "type": "block", "nature": "ADDITIVE",
       "parameters": {"dx": 40, "dy": 40, "dz": "wall"}},
      {"id": "hole", "type": "cylinder", "nature": "SUBTRACTIVE",
       "parameters": {"radius": 8, "height": 20}, "placement": {"origin": [0, 0, -5]}}],
    "sizes": [{"id": "rim", "on": "hole.wall", "size": 0.5}],
    "groups": {"load": "base.top"}})");
}

TEST(ModelChanges, AreNoneOfAModelAndItself) {
  EXPECT_THAT(model_changes(plate(), plate()), IsEmpty());
}

TEST(ModelChanges, TellParametersBeforeAndAfter) {
  FeatureModel after = plate();
  after.mutable_parameters(0)->mutable_value()->set_number_value(8.5);
  after.mutable_parameters(1)->mutable_value()->set_string_value("wall");
  after.mutable_features(1)->mutable_parameters(0)->mutable_value()->set_number_value(9);
  EXPECT_THAT(model_changes(plate(), after),
              ElementsAre("wall 7 -> 8.5", "depth wall / 2 -> wall", "hole.radius 8 -> 9"));
}

TEST(ModelChanges, TellFeaturesThatCameWentAndMoved) {
  FeatureModel after = plate();
  after.mutable_features(1)->set_id("drill");
  after.mutable_features(0)->mutable_placement()->add_origin()->set_number_value(3);
  EXPECT_THAT(model_changes(plate(), after), ElementsAre("base moved", "+ drill", "- hole"));
}

TEST(ModelChanges, TellWhatElseIsChanged) {
  FeatureModel after = plate();
  after.mutable_parameters(0)->set_upper(9);
  after.mutable_features(1)->set_nature(remesh::v1::Feature::ADDITIVE);
  after.mutable_features()->SwapElements(0, 1);
  after.mutable_sizes(0)->mutable_size()->set_number_value(0.25);
  after.mutable_groups(0)->set_on("base.bottom");
  after.add_groups()->set_name("held");
  EXPECT_THAT(model_changes(plate(), after),
              ElementsAre("wall changed", "hole changed", "order of features changed",
                          "size rim 0.5 -> 0.25", "group load changed", "+ group held"));
}

TEST(ModelChanges, TellWhereSizesHoldNow) {
  FeatureModel after = plate();
  after.mutable_sizes(0)->set_on("hole.wall | base.top");
  EXPECT_THAT(model_changes(plate(), after),
              ElementsAre("size rim on hole.wall -> hole.wall | base.top"));
  after.mutable_sizes(0)->mutable_size()->set_number_value(0.25);
  after.mutable_sizes(0)->mutable_region()->mutable_ball()->add_values()->set_number_value(1);
  EXPECT_THAT(model_changes(plate(), after),
              ElementsAre("size rim 0.5 -> 0.25", "size rim at another place"));
}

}  // namespace
}  // namespace remeshd::cli
