#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/model/feature_model.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"

namespace remeshd {
namespace {

using testing::HasSubstr;

/// `wall` from 2 to 8, `holes` whole, `double_wall` at most 12 and twice as much as `wall`.
ModelSource model() {
  ModelSource model = test::one_feature(test::block("plate", 10, 10, 10));
  model.parameters = {{.name = "wall", .value = 4.0, .lower = 2.0, .upper = 8.0},
                      {.name = "holes", .value = 3.0, .integer = true},
                      {.name = "double_wall", .value = "2*wall", .upper = 12.0}};
  return model;
}

ModelSource with(const std::string& name, const Scalar& value) {
  ModelSource changed = model();
  test::parameter(changed, name) = value;
  return changed;
}

ErrorInfo refused(const ModelSource& source) {
  return test::error_of([&] { evaluate(source); });
}

TEST(ParameterBounds, HoldForNumbersAndExpressionsAndAreInThemselvesAllowed) {
  EXPECT_NO_THROW(evaluate(model()));
  for (const Scalar& value : {Scalar(2.0), Scalar(6.0), Scalar("2+1")})
    EXPECT_NO_THROW(evaluate(with("wall", value)));
  for (const Scalar& value : {Scalar(std::nextafter(2.0, 0.0)), Scalar("8.5"), Scalar(-3.0)})
    EXPECT_EQ(test::place_of(refused(with("wall", value))), "VALUE_OUT_OF_RANGE - wall");
}

TEST(ParameterBounds, AreNamedWithTheValue) {
  const ErrorInfo both = refused(with("wall", 9.5));
  EXPECT_EQ(both.kind, ErrorKind::InvalidArgument);
  EXPECT_EQ(both.message, "parameter 'wall' is 9.5, but must be between 2 and 8");
  const ErrorInfo upper = refused(with("double_wall", 12.5));
  EXPECT_EQ(upper.message, "parameter 'double_wall' is 12.5, but must be at most 12");
  ModelSource source = model();
  source.parameters[1].lower = 4;
  EXPECT_EQ(refused(source).message, "parameter 'holes' is 3, but must be at least 4");
}

TEST(ParameterBounds, HoldForWhatFollowsFromAnotherParameter) {
  EXPECT_NO_THROW(evaluate(with("wall", 6.0)));
  const ErrorInfo info = refused(with("wall", 7.0));
  EXPECT_EQ(test::place_of(info), "VALUE_OUT_OF_RANGE - double_wall");
  EXPECT_THAT(info.message, HasSubstr("is 14"));
}

TEST(ParameterBounds, AnIntegerIsWholeWithoutTolerance) {
  EXPECT_NO_THROW(evaluate(with("holes", -2.0)));
  EXPECT_NO_THROW(evaluate(with("holes", "6/2")));
  EXPECT_EQ(test::place_of(refused(with("holes", 3 + 1e-12))), "VALUE_OUT_OF_RANGE - holes");
  EXPECT_THAT(refused(with("holes", 2.5)).message, HasSubstr("must be a whole number"));
}

TEST(ParameterBounds, ThatLeaveNoValueAreRefused) {
  ModelSource source = model();
  source.parameters[0].lower = 8.5;
  EXPECT_EQ(test::place_of(refused(source)), "BOUNDS_INVALID - wall");
  source.parameters[0].lower = 8;
  source.parameters[0].value = 8.0;
  source.parameters[2].upper.reset();
  EXPECT_NO_THROW(evaluate(source));
  for (const double bound : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    source.parameters[0].upper = bound;
    EXPECT_EQ(test::place_of(refused(source)), "BOUNDS_INVALID - wall");
  }
}

TEST(ParameterBounds, ANameStandsOnce) {
  ModelSource source = model();
  source.parameters.push_back({"wall", 5.0});
  EXPECT_EQ(test::place_of(refused(source)), "DUPLICATE_PARAMETER - wall");
}

TEST(ParameterBounds, AnEditThatPassesThemIsRefusedWithItsIndex) {
  const auto refused_edit = [](std::vector<Edit> edits) {
    return test::error_of([&] { evaluate_edited(model(), {std::move(edits)}); });
  };
  const ErrorInfo set = refused_edit(
      {SetParameter{"holes", 4.0}, SetParameter{"wall", 9.0}, SetParameter{"holes", 5.0}});
  EXPECT_EQ(test::place_of(set), "VALUE_OUT_OF_RANGE - wall");
  EXPECT_EQ(set.edit_index, 1);
  // It follows from the wall, which the second edit sets.
  const ErrorInfo follows = refused_edit({SetParameter{"holes", 4.0}, SetParameter{"wall", 7.0}});
  EXPECT_EQ(test::place_of(follows), "VALUE_OUT_OF_RANGE - double_wall");
  EXPECT_EQ(follows.edit_index, 1);
}

TEST(ParameterBounds, HoldForTheModelAtTheEndOfAnEdit) {
  EXPECT_NO_THROW(
      evaluate_edited(model(), {{SetParameter{"wall", 7.0}, SetParameter{"double_wall", 1.0}}}));
  EXPECT_NO_THROW(
      evaluate_edited(model(), {{SetParameter{"wall", 70.0}, SetParameter{"wall", 5.0}}}));
}

TEST(ParameterBounds, StayWithTheirParameterThroughAnEdit) {
  const ModelSource edited = apply(model(), {{SetParameter{"wall", 5.0}}});
  EXPECT_EQ(edited, with("wall", 5.0));
}

}  // namespace
}  // namespace remeshd
