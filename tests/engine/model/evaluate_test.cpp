#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/model/feature_model.h"
#include "engine/model/solid.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"

namespace remeshd {
namespace {

using test::feature;
using test::point;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

ErrorInfo error_of(const ModelSource& model) {
  return test::error_of([&] { evaluate(model); });
}
std::string failure_of(const ModelSource& model) { return test::place_of(error_of(model)); }
std::string failure_of(const FeatureSource& only) { return failure_of(test::one_feature(only)); }
Feature evaluated(const FeatureSource& only) {
  return evaluate(test::one_feature(only)).features.at(0);
}

FeatureSource block() { return feature("plate", "block", {{"dx", 3.0}, {"dy", 2.0}, {"dz", 1.0}}); }
FeatureSource with_parameter(FeatureSource f, const std::string& name, Scalar value) {
  f.parameters[name] = std::move(value);
  return f;
}

TEST(Evaluate, FeaturesKeepTheirOrderIdsAndNatures) {
  const FeatureModel model = test::case_features("tool2-a");
  EXPECT_EQ(model.name, "tool2-a");
  ASSERT_EQ(model.features.size(), 8U);
  EXPECT_EQ(model.features[0].id, "base");
  EXPECT_EQ(model.features[2].nature, Nature::Subtractive);
  EXPECT_EQ(model.features[6].nature, Nature::Additive);
  EXPECT_EQ(model.index_of("pipe_inner"), 7);
  EXPECT_EQ(model.index_of("pipe"), -1);
  EXPECT_EQ(std::get<Cylinder>(model.features[7].shape).height, 52);
  EXPECT_EQ(model.features[7].placement, Transform::translation({15, 0, 0}));
}

TEST(Evaluate, EverySizeMayBeAnExpression) {
  ModelSource model = test::one_feature(
      feature("torus1", "torus", {{"major_radius", "2*r"}, {"minor_radius", "r/2"}}));
  model.parameters = {{"r", 4.0}};
  const auto torus = std::get<Torus>(evaluate(model).features[0].shape);
  EXPECT_EQ(torus.major_radius, 8);
  EXPECT_EQ(torus.minor_radius, 2);
}

TEST(Evaluate, ModelsWithoutMaterialAreRefused) {
  EXPECT_EQ(failure_of(ModelSource{}), "NO_FEATURES - -");
  FeatureSource hole = block();
  hole.nature = Nature::Subtractive;
  EXPECT_EQ(failure_of(hole), "NO_ADDITIVE_FEATURE - -");
}

TEST(Evaluate, ErrorsAreInvalidArgumentsOfTheModelWithAHint) {
  for (const ModelSource& model :
       {ModelSource{}, test::one_feature(with_parameter(block(), "dx", 0.0)),
        test::one_feature(with_parameter(block(), "colour", 1.0)),
        test::one_feature(with_parameter(block(), "dx", "1/0")),
        test::one_feature(with_parameter(block(), "dx", "q"))}) {
    const ErrorInfo info = error_of(model);
    EXPECT_EQ(info.kind, ErrorKind::InvalidArgument) << info.message;
    EXPECT_EQ(info.stage, "model") << info.message;
    EXPECT_FALSE(info.hint.empty()) << info.message;
    EXPECT_FALSE(info.edit_index.has_value());
  }
}

TEST(Evaluate, FeatureIdsAreNames) {
  for (const char* id : {"", "1st", "a.b", "a b", "hole-1", "pi", "sqrt"}) {
    FeatureSource f = block();
    f.id = id;
    const ErrorInfo info = error_of(test::one_feature(f));
    EXPECT_EQ(info.reason, "INVALID_NAME") << id;
    EXPECT_EQ(test::joined(info.features), id);
    EXPECT_EQ(info.parameter, "id");
  }
}

TEST(Evaluate, LongNamesAreCutInErrors) {
  FeatureSource f = block();
  for (int k = 0; k < 100000; ++k) f.id += "\xC3\xA4";
  const ErrorInfo info = error_of(test::one_feature(f));
  EXPECT_EQ(info.reason, "INVALID_NAME");
  const std::string& id = info.features.at(0);
  EXPECT_LT(info.message.size() + id.size() + info.hint.size(), 1000U);
  EXPECT_EQ(id.substr(id.size() - 5), "\xC3\xA4...");
}

TEST(Evaluate, IdsAreUnique) {
  ModelSource model = test::one_feature(block());
  model.features.push_back(block());
  EXPECT_EQ(failure_of(model), "DUPLICATE_FEATURE plate -");
}

TEST(Evaluate, TypesAreThoseOfTheTable) {
  FeatureSource f = block();
  f.type = "Block";
  EXPECT_EQ(failure_of(f), "UNKNOWN_FEATURE_TYPE plate type");
  f.type = "";
  EXPECT_EQ(failure_of(f), "UNKNOWN_FEATURE_TYPE plate type");
}

TEST(Evaluate, EachParameterOfATypeIsRequiredAndNoOtherIsTaken) {
  for (const FeatureTypeInfo& type : feature_types()) {
    FeatureSource whole = feature("f", type.name);
    double size = 8;  // falls, so that length > width and major > minor
    for (const ParameterInfo& p : type.parameters) {
      if (p.unit == "profile")
        whole.profile = {point(1.0, 0.0), point(2.0, 0.0), point(2.0, 1.0)};
      else
        whole.parameters[p.name] = size /= 2;
    }
    EXPECT_NO_THROW(evaluate(test::one_feature(whole))) << type.name;
    EXPECT_EQ(failure_of(with_parameter(whole, "colour", 1.0)), "UNKNOWN_PARAMETER f colour")
        << type.name;
    for (const ParameterInfo& p : type.parameters) {
      FeatureSource part = whole;
      if (p.unit == "profile")
        part.profile.reset();
      else
        part.parameters.erase(p.name);
      if (p.required) {
        EXPECT_EQ(failure_of(part), "MISSING_PARAMETER f " + p.name) << type.name;
      } else {
        EXPECT_NO_THROW(evaluate(test::one_feature(part))) << type.name;
      }
    }
  }
}

TEST(Evaluate, SizesOfEveryTypeMustBePositiveFiniteAndInRange) {
  for (const FeatureTypeInfo& type : feature_types()) {
    FeatureSource whole = feature("f", type.name);
    double size = 8;
    for (const ParameterInfo& p : type.parameters) {
      if (p.unit == "profile")
        whole.profile = {point(1.0, 0.0), point(2.0, 0.0), point(2.0, 1.0)};
      else
        whole.parameters[p.name] = size /= 2;
    }
    for (const ParameterInfo& p : type.parameters) {
      if (p.unit == "profile") continue;
      const std::string place = "f " + p.name;
      EXPECT_EQ(failure_of(with_parameter(whole, p.name, -1.0)), "DEGENERATE_FEATURE " + place)
          << type.name;
      EXPECT_EQ(failure_of(with_parameter(whole, p.name, kNaN)), "NON_FINITE_VALUE " + place)
          << type.name;
      EXPECT_EQ(failure_of(with_parameter(whole, p.name, kInfinity)), "NON_FINITE_VALUE " + place)
          << type.name;
      EXPECT_EQ(failure_of(with_parameter(whole, p.name, "1/0")), "NON_FINITE_VALUE " + place)
          << type.name;
      EXPECT_EQ(failure_of(with_parameter(whole, p.name, "1,2")), "INVALID_EXPRESSION " + place)
          << type.name;
      EXPECT_EQ(failure_of(with_parameter(whole, p.name, "f=2")), "INVALID_EXPRESSION " + place)
          << type.name;
      EXPECT_EQ(failure_of(with_parameter(whole, p.name, "nope")), "UNKNOWN_NAME " + place)
          << type.name;
      if (p.unit == "length") {
        EXPECT_EQ(failure_of(with_parameter(whole, p.name, 1.1e9)), "VALUE_OUT_OF_RANGE " + place)
            << type.name;
        EXPECT_EQ(failure_of(with_parameter(whole, p.name, 1e-10)), "VALUE_OUT_OF_RANGE " + place)
            << type.name;
      }
      if (type.name != "cone" || p.name == "height") {
        EXPECT_EQ(failure_of(with_parameter(whole, p.name, 0.0)), "DEGENERATE_FEATURE " + place)
            << type.name;
      }
    }
  }
}

TEST(Evaluate, OneRadiusOfAConeMayBeZeroAndBothMayBeEqual) {
  const auto cone = [](double bottom, double top) {
    return feature("c", "cone", {{"radius_bottom", bottom}, {"radius_top", top}, {"height", 2.0}});
  };
  EXPECT_EQ(std::get<Cone>(evaluated(cone(0, 3)).shape).radius_bottom, 0);
  EXPECT_EQ(std::get<Cone>(evaluated(cone(3, 0)).shape).radius_top, 0);
  EXPECT_EQ(Solid(evaluated(cone(3, 3))).faces()[0].surface.kind, Surface::Kind::Cylinder);
  EXPECT_EQ(failure_of(cone(0, 0)), "DEGENERATE_FEATURE c radius_top");
}

TEST(Evaluate, SizesMustFitEachOther) {
  const auto torus = [](double major, double minor) {
    return feature("t", "torus", {{"major_radius", major}, {"minor_radius", minor}});
  };
  EXPECT_EQ(failure_of(torus(2, 2)), "DEGENERATE_FEATURE t minor_radius");
  EXPECT_EQ(failure_of(torus(2, 3)), "DEGENERATE_FEATURE t minor_radius");
  EXPECT_NO_THROW(evaluated(torus(2, 1.999)));
  const auto slot = [](double length, double width) {
    return feature("s", "slot", {{"length", length}, {"width", width}, {"height", 1.0}});
  };
  EXPECT_EQ(failure_of(slot(2, 2)), "DEGENERATE_FEATURE s length");
  EXPECT_EQ(failure_of(slot(2, 3)), "DEGENERATE_FEATURE s length");
  EXPECT_NO_THROW(evaluated(slot(3, 2)));
}

TEST(Evaluate, AngleOfARevolutionIsAboveZeroAndAtMost360Degrees) {
  const auto ring = [](const Scalar& angle) {
    return feature("r", "revolution", {point(1.0, 0.0), point(2.0, 0.0), point(2.0, 1.0)},
                   {{"angle", angle}});
  };
  EXPECT_EQ(failure_of(ring(0.0)), "DEGENERATE_FEATURE r angle");
  EXPECT_EQ(failure_of(ring(-90.0)), "DEGENERATE_FEATURE r angle");
  EXPECT_EQ(failure_of(ring(360.001)), "DEGENERATE_FEATURE r angle");
  EXPECT_EQ(std::get<Revolution>(evaluated(ring(90.0)).shape).angle, std::numbers::pi / 2);
  EXPECT_EQ(std::get<Revolution>(evaluated(ring(360.0)).shape).angle, 2 * std::numbers::pi);
  EXPECT_EQ(std::get<Revolution>(evaluated(ring("2*pi/deg")).shape).angle, 2 * std::numbers::pi);
  FeatureSource whole = ring(0.0);
  whole.parameters.clear();
  EXPECT_EQ(std::get<Revolution>(evaluated(whole).shape).angle, 2 * std::numbers::pi);
}

TEST(Evaluate, ProfilesBelongToPrismsAndRevolutionsAlone) {
  FeatureSource f = block();
  f.profile = {point(0.0, 0.0), point(1.0, 0.0), point(0.0, 1.0)};
  EXPECT_EQ(failure_of(f), "UNKNOWN_PARAMETER plate profile");
  EXPECT_EQ(failure_of(feature("p", "prism", {{"profile", 3.0}, {"height", 1.0}})),
            "WRONG_VALUE_KIND p profile");
}

TEST(Evaluate, ParametersOfTheModelAreCheckedEvenWhereUnused) {
  ModelSource model = test::one_feature(block());
  model.parameters = {{"a", "b"}, {"b", "a"}};
  EXPECT_EQ(failure_of(model), "CYCLIC_PARAMETERS - a");
  model.parameters = {{"a", "1/0"}};
  EXPECT_EQ(failure_of(model), "NON_FINITE_VALUE - a");
  model.parameters = {{"sin", 1.0}};
  EXPECT_EQ(failure_of(model), "INVALID_NAME - sin");
}

TEST(Evaluate, NumberOfFeaturesIsLimited) {
  ModelSource model;
  for (int k = 0; k <= 10000; ++k) {
    model.features.push_back(block());
    model.features.back().id += std::to_string(k);
  }
  EXPECT_EQ(failure_of(model), "LIMIT_EXCEEDED - -");
  model.features.pop_back();
  EXPECT_EQ(evaluate(model).features.size(), 10000U);
}

TEST(Reference, OriginStaysAtThePlacement) {
  const Feature f = evaluated(block());
  EXPECT_EQ(f.reference, (Vec3{0, 0, 0}));
  EXPECT_EQ(f.alignment, f.placement);
}

TEST(Reference, CentreIsThatOfTheLocalBox) {
  FeatureSource f = block();
  f.reference = ReferenceKind::Centre;
  f.placement.origin = {10.0, 20.0, 30.0};
  EXPECT_EQ(evaluated(f).reference, (Vec3{0, 0, 0.5}));
  EXPECT_EQ(evaluated(f).alignment, Transform::translation({10, 20, 30.5}));
  FeatureSource wedge =
      feature("w", "prism", {point(2.0, 0.0), point(6.0, 0.0), point(2.0, 2.0)}, {{"height", 4.0}});
  wedge.reference = ReferenceKind::Centre;
  EXPECT_EQ(evaluated(wedge).reference, (Vec3{4, 1, 2}));
  EXPECT_EQ(test::case_features("fig10-a").features[1].alignment,
            Transform::translation({0, 0, 16}));
}

TEST(Reference, APointIsTakenAsGivenAndChecked) {
  FeatureSource f = block();
  f.reference = std::array<Scalar, 3>{1.0, "2*3", -4.0};
  EXPECT_EQ(evaluated(f).reference, (Vec3{1, 6, -4}));
  f.reference = std::array<Scalar, 3>{1.0, "2*q", -4.0};
  EXPECT_EQ(failure_of(f), "UNKNOWN_NAME plate referencePoint[1]");
  f.reference = std::array<Scalar, 3>{1.0, kNaN, -4.0};
  EXPECT_EQ(failure_of(f), "NON_FINITE_VALUE plate referencePoint[1]");
  f.reference = std::array<Scalar, 3>{1.0, 2e9, -4.0};
  EXPECT_EQ(failure_of(f), "VALUE_OUT_OF_RANGE plate referencePoint[1]");
}

TEST(Reference, AlignmentCarriesTheRotation) {
  FeatureSource f = block();
  f.placement.origin = {10.0, 0.0, 0.0};
  f.placement.z_axis = std::array<Scalar, 3>{0.0, 1.0, 0.0};
  f.placement.x_axis = std::array<Scalar, 3>{0.0, 0.0, 1.0};
  f.reference = std::array<Scalar, 3>{1.0, 2.0, 3.0};
  EXPECT_EQ(evaluated(f).alignment.apply({}), (Vec3{12, 3, 1}));
}

}  // namespace
}  // namespace remeshd
