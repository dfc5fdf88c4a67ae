#include <gtest/gtest.h>

#include "engine/model/feature_model.h"
#include "tests/support/cases.h"

namespace remeshd {
namespace {

using test::arc;
using test::point;

/// One feature of each type, for a model about 100 across: the tolerance is about 1e-10.
ModelSource original() {
  ModelSource model =
      test::one_feature(test::feature("base", "block", {{"dx", 60.0}, {"dy", 60.0}, {"dz", 60.0}}));
  model.features.push_back(test::feature("pin", "cylinder", {{"radius", 4.0}, {"height", 9.0}}));
  model.features.push_back(
      test::feature("tip", "cone", {{"radius_bottom", 4.0}, {"radius_top", 2.0}, {"height", 9.0}}));
  model.features.push_back(test::feature("ball", "sphere", {{"radius", 4.0}}));
  model.features.push_back(
      test::feature("tyre", "torus", {{"major_radius", 8.0}, {"minor_radius", 2.0}}));
  model.features.push_back(test::feature(
      "web", "prism", {point(0.0, 0.0), point(9.0, 0.0), arc(9.0, 9.0, 10.0, 4.0), point(0.0, 9.0)},
      {{"height", 9.0}}));
  model.features.push_back(test::feature("arch", "revolution",
                                         {point(5.0, 0.0), point(9.0, 0.0), point(9.0, 4.0)},
                                         {{"angle", 90.0}}));
  model.features.push_back(
      test::feature("key", "slot", {{"length", 9.0}, {"width", 4.0}, {"height", 3.0}}));
  return model;
}

bool same(const ModelSource& a, const ModelSource& b) {
  return same_geometry(evaluate(a), evaluate(b)) && same_geometry(evaluate(b), evaluate(a));
}

TEST(SameGeometry, EveryParameterOfEveryTypeCounts) {
  ModelSource changed = original();
  for (FeatureSource& feature : changed.features) {
    for (auto& [name, value] : feature.parameters) {
      const double before = std::get<double>(value);
      value = before + 1e-13;
      EXPECT_TRUE(same(original(), changed)) << feature.id << " " << name;
      value = before + 1e-7;
      EXPECT_FALSE(same(original(), changed)) << feature.id << " " << name;
      value = before;
    }
  }
}

TEST(SameGeometry, EveryPointOfAProfileCounts) {
  for (const std::size_t f : {5U, 6U}) {
    for (std::size_t k = 0; k < original().features[f].profile->size(); ++k) {
      ModelSource changed = original();
      Scalar& x = (*changed.features[f].profile)[k].x;
      x = std::get<double>(x) + 1e-9;
      EXPECT_FALSE(same(original(), changed)) << f << " " << k;
    }
  }
  ModelSource changed = original();
  (*(*changed.features[5].profile)[2].through)[0] = 10.0 + 1e-9;
  EXPECT_FALSE(same(original(), changed));
}

TEST(SameGeometry, PlacementCounts) {
  ModelSource changed = original();
  changed.features[7].placement.origin[2] = 1e-13;
  EXPECT_TRUE(same(original(), changed));
  changed.features[7].placement.origin[2] = 1e-9;
  EXPECT_FALSE(same(original(), changed));
  changed = original();
  changed.features[7].placement.x_axis = std::array<Scalar, 3>{1.0, 1e-9, 0.0};
  EXPECT_FALSE(same(original(), changed));
}

TEST(SameGeometry, WordingDoesNotCount) {
  ModelSource changed = original();
  changed.name = "other";
  changed.parameters = {{"r", 4.0}};
  changed.features[1].parameters["radius"] = "r";
  changed.features[1].placement.z_axis = std::array<Scalar, 3>{0.0, 0.0, 5.0};
  changed.features[3].reference = std::array<Scalar, 3>{1.0, 2.0, 3.0};
  EXPECT_TRUE(same(original(), changed));
}

TEST(SameGeometry, IdsNaturesOrderTypesAndNumberCount) {
  ModelSource changed = original();
  changed.features[1].id = "peg";
  EXPECT_FALSE(same(original(), changed));
  changed = original();
  changed.features[1].nature = Nature::Subtractive;
  EXPECT_FALSE(same(original(), changed));
  changed = original();
  std::swap(changed.features[1], changed.features[2]);
  EXPECT_FALSE(same(original(), changed));
  changed = original();
  changed.features.pop_back();
  EXPECT_FALSE(same(original(), changed));
  changed = original();
  changed.features[1] = test::feature("pin", "sphere", {{"radius", 4.0}});
  EXPECT_FALSE(same(original(), changed));
  changed = original();
  changed.features[5].profile->erase(changed.features[5].profile->begin() + 1);
  EXPECT_FALSE(same(original(), changed));
}

TEST(SameGeometry, ToleranceFollowsTheSizeOfTheModel) {
  ModelSource a =
      test::one_feature(test::feature("base", "block", {{"dx", 1e6}, {"dy", 1e6}, {"dz", 1e6}}));
  ModelSource b = a;
  b.features[0].parameters["dz"] = 1e6 + 1e-7;  // 6e-14 of the diagonal
  EXPECT_TRUE(same(a, b));
  b.features[0].parameters["dz"] = 1e6 + 1e-5;  // 6e-12
  EXPECT_FALSE(same(a, b));
}

}  // namespace
}  // namespace remeshd
