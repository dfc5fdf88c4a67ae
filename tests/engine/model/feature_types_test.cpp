#include "engine/model/feature_types.h"

#include <gtest/gtest.h>

namespace remeshd {
namespace {

std::vector<std::string> names(const std::vector<ParameterInfo>& parameters) {
  std::vector<std::string> result;
  for (const ParameterInfo& p : parameters) result.push_back(p.name);
  return result;
}

using Names = std::vector<std::string>;

TEST(FeatureTypes, AreTheRowsOfTheContract) {
  struct Row {
    std::string type;
    Names parameters, faces;
  };
  const std::vector<Row> rows{
      {"block", {"dx", "dy", "dz"}, {"x_min", "x_max", "y_min", "y_max", "bottom", "top"}},
      {"cylinder", {"radius", "height"}, {"wall", "bottom", "top"}},
      {"cone", {"radius_bottom", "radius_top", "height"}, {"wall", "bottom", "top"}},
      {"sphere", {"radius"}, {"surface"}},
      {"torus", {"major_radius", "minor_radius"}, {"surface"}},
      {"prism", {"profile", "height"}, {"side#", "bottom", "top"}},
      {"revolution", {"profile", "angle"}, {"side#", "start", "end"}},
      {"slot", {"length", "width", "height"}, {"wall", "bottom", "top"}},
  };
  ASSERT_EQ(feature_types().size(), rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_EQ(feature_types()[k].name, rows[k].type);
    EXPECT_EQ(names(feature_types()[k].parameters), rows[k].parameters);
    EXPECT_EQ(feature_types()[k].faces, rows[k].faces);
    EXPECT_FALSE(feature_types()[k].description.empty());
  }
}

TEST(FeatureTypes, ParametersHaveAUnitAndADescriptionAndADefaultWhereOptional) {
  for (const FeatureTypeInfo& type : feature_types()) {
    for (const ParameterInfo& p : type.parameters) {
      EXPECT_TRUE(p.unit == "length" || p.unit == "deg" || p.unit == "profile") << p.name;
      EXPECT_FALSE(p.description.empty()) << p.name;
      EXPECT_EQ(p.required, p.default_value.empty()) << p.name;
    }
  }
}

TEST(FeatureTypes, AreFoundByName) {
  ASSERT_NE(find_feature_type("slot"), nullptr);
  EXPECT_EQ(find_feature_type("slot")->name, "slot");
  EXPECT_EQ(find_feature_type("Slot"), nullptr);
  EXPECT_EQ(find_parameter(*find_feature_type("revolution"), "angle")->default_value, "360");
  EXPECT_EQ(find_parameter(*find_feature_type("slot"), "radius"), nullptr);
}

}  // namespace
}  // namespace remeshd
