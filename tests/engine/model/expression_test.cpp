#include "engine/model/expression.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/random.h"
#include "tests/support/expect_error.h"

namespace remeshd {
namespace {

using Parameters = std::vector<ParameterSource>;

double value_of(const Scalar& scalar, const Parameters& parameters = {}) {
  return Scope(parameters).value(scalar, "plate", "radius");
}
std::string expression_failure(const Scalar& scalar, const Parameters& parameters = {}) {
  return test::place_of(test::error_of([&] { value_of(scalar, parameters); }));
}
std::string failure_of_parameters(const Parameters& parameters) {
  return test::place_of(test::error_of([&] { const Scope scope(parameters); }));
}

TEST(Expression, NumbersAreTakenAsTheyAre) {
  EXPECT_EQ(value_of(0.1), 0.1);
  EXPECT_EQ(value_of(-2.5e300), -2.5e300);
}

TEST(Expression, ArithmeticFollowsTheUsualPrecedence) {
  EXPECT_EQ(value_of("1+2*3"), 7);
  EXPECT_EQ(value_of("(1+2)*3"), 9);
  EXPECT_EQ(value_of("2^3^2"), 512);
  EXPECT_EQ(value_of("-2^2"), -4);
  EXPECT_EQ(value_of("7/2"), 3.5);
  EXPECT_EQ(value_of(" 1e3 + .5 "), 1000.5);
  EXPECT_EQ(value_of("max(1, 2, 3) - min(4, 5)"), -1);
  EXPECT_EQ(value_of("2 >= 1 ? 10 : 20"), 10);
  EXPECT_EQ(value_of("2 == 1 ? 10 : 20"), 20);
  EXPECT_EQ(value_of("2 != 1 && 1 <= 1"), 1);
}

TEST(Expression, PiAndDegHaveFullPrecision) {
  EXPECT_EQ(value_of("pi"), std::numbers::pi);
  EXPECT_EQ(value_of("deg"), std::numbers::pi / 180);
  EXPECT_EQ(value_of("36*cos(45*deg)"), 36 * std::cos(45 * (std::numbers::pi / 180)));
}

TEST(Expression, EveryOperationRoundsOnceAsWritten) {
  const Parameters a{{"a", 0.1}, {"b", 3.3}};
  EXPECT_EQ(value_of("3*a+0.7", a), 3 * 0.1 + 0.7);
  EXPECT_EQ(value_of("b-a*b", a), 3.3 - 0.1 * 3.3);
  EXPECT_EQ(value_of("b/3/7", a), 3.3 / 3 / 7);
}

TEST(Expression, ParametersMayUseEachOtherInAnyOrder) {
  const Parameters chain{{"a", "b+1"}, {"b", "2*c"}, {"c", 5.0}, {"d", "a*b*c"}};
  EXPECT_EQ(value_of("d", chain), 11 * 10 * 5);
}

TEST(Expression, NamesAreCaseSensitive) {
  EXPECT_EQ(value_of("r*10+R", {{"r", 1.0}, {"R", 2.0}}), 12);
  EXPECT_EQ(expression_failure("R", {{"r", 1.0}}), "UNKNOWN_NAME plate radius");
}

TEST(Expression, ALongChainOfParametersIsNoProblem) {
  Parameters chain{{"p0", 1.0}};
  for (int k = 1; k < 9999; ++k)
    chain.push_back({"p" + std::to_string(k), "p" + std::to_string(k - 1) + "+1"});
  EXPECT_EQ(value_of("p9998", chain), 9999);
}

TEST(Expression, TextThatIsNoExpressionIsRefused) {
  for (const char* text : {"", "  ", "1+", "(1", "1)", "1 2", "sin()", "sin(1,2)", "\"text\"",
                           "1;2", "$", "1?2", "()", "max()", "foo(1)", "--1", "5%2"})
    EXPECT_EQ(expression_failure(text), "INVALID_EXPRESSION plate radius") << text;
}

TEST(Expression, CommaListsAreRefused) {
  EXPECT_EQ(expression_failure("1,2"), "INVALID_EXPRESSION plate radius");
  EXPECT_EQ(expression_failure("(1,2)"), "INVALID_EXPRESSION plate radius");
  EXPECT_EQ(expression_failure("1,"), "INVALID_EXPRESSION plate radius");
  EXPECT_EQ(failure_of_parameters({{"a", "1,2"}}), "INVALID_EXPRESSION - a");
}

TEST(Expression, AssignmentsAreRefusedAndChangeNothing) {
  const Parameters a{{"a", 1.0}};
  for (const char* text : {"a=3", "a = 3", "(a=3)", "a=3, a", "b=a", "a=", "=3", "1+(a=2)"})
    EXPECT_EQ(expression_failure(text, a), "INVALID_EXPRESSION plate radius") << text;
  const Scope scope(a);
  test::error_of([&] { static_cast<void>(scope.value("a=3", "plate", "radius")); });
  EXPECT_EQ(scope.value("a", "plate", "radius"), 1);
}

TEST(Expression, ResultsThatAreNotFiniteAreRefused) {
  for (const char* text :
       {"1/0", "-1/0", "0/0", "sqrt(-1)", "ln(0)", "10^400", "acos(2)", "1e308*10"})
    EXPECT_EQ(expression_failure(text), "NON_FINITE_VALUE plate radius") << text;
  EXPECT_EQ(expression_failure(std::numeric_limits<double>::quiet_NaN()),
            "NON_FINITE_VALUE plate radius");
  EXPECT_EQ(expression_failure(std::numeric_limits<double>::infinity()),
            "NON_FINITE_VALUE plate radius");
  EXPECT_EQ(failure_of_parameters({{"a", "1/b"}, {"b", 0.0}}), "NON_FINITE_VALUE - a");
  EXPECT_EQ(failure_of_parameters({{"a", -HUGE_VAL}}), "NON_FINITE_VALUE - a");
}

TEST(Expression, UnknownNamesAreNamed) {
  EXPECT_EQ(expression_failure("2*width", {{"height", 1.0}}), "UNKNOWN_NAME plate radius");
  EXPECT_EQ(failure_of_parameters({{"a", "2*width"}}), "UNKNOWN_NAME - a");
  const ErrorInfo info = test::error_of([] { value_of("2*width"); });
  EXPECT_NE(info.message.find("'width'"), std::string::npos) << info.message;
}

TEST(Expression, MuParsersOwnConstantsAreUnknown) {
  EXPECT_EQ(expression_failure("_pi"), "UNKNOWN_NAME plate radius");
  EXPECT_EQ(expression_failure("_e"), "UNKNOWN_NAME plate radius");
  EXPECT_EQ(value_of("_pi", {{"_pi", 3.0}}), 3);
}

TEST(Expression, CirclesAreSpelled) {
  const ErrorInfo info = test::error_of([] {
    const Scope scope({{"a", "b"}, {"b", "c+1"}, {"c", "2*b"}, {"d", "a"}});
  });
  EXPECT_EQ(test::place_of(info), "CYCLIC_PARAMETERS - b");
  EXPECT_NE(info.message.find("b -> c -> b"), std::string::npos) << info.message;
  EXPECT_EQ(failure_of_parameters({{"a", "a+1"}}), "CYCLIC_PARAMETERS - a");
}

TEST(Expression, NamesOfParametersFollowTheRule) {
  EXPECT_EQ(value_of("_a1", {{"_a1", 2.0}}), 2);
  const std::string longest(64, 'x');
  EXPECT_EQ(value_of(longest, {{longest, 2.0}}), 2);
  for (const std::string& name :
       {std::string(), std::string("1a"), std::string("a-b"), std::string("a b"),
        std::string("\xC3\xA4"), std::string("pi"), std::string("deg"), std::string("sin"),
        std::string("max"), std::string("rint"), std::string(65, 'x')}) {
    const ErrorInfo info = test::error_of([&, name = name] { const Scope scope({{name, 1.0}}); });
    EXPECT_EQ(info.reason, "INVALID_NAME") << name;
    EXPECT_EQ(info.parameter, name);
    EXPECT_EQ(info.features, FeatureIds{});
  }
}

TEST(Expression, LengthIsLimited) {
  std::string text = "1";
  while (text.size() + 2 <= kMaxExpressionLength) text += "+1";
  EXPECT_EQ(value_of(text), (static_cast<double>(text.size()) + 1) / 2);
  EXPECT_EQ(expression_failure(text + "+1"), "INVALID_EXPRESSION plate radius");
}

TEST(Expression, NumberOfParametersIsLimited) {
  Parameters many;
  for (int k = 0; k <= 10000; ++k) many.push_back({"p" + std::to_string(k), 1.0});
  EXPECT_EQ(failure_of_parameters(many), "LIMIT_EXCEEDED - -");
}

TEST(Expression, CharactersOutsideAsciiAreRefused) {
  EXPECT_EQ(expression_failure("1+\xC2\xA0"
                               "1"),
            "INVALID_EXPRESSION plate radius");
  EXPECT_EQ(expression_failure(std::string("1\0+1", 4)), "INVALID_EXPRESSION plate radius");
  EXPECT_EQ(expression_failure("1\n+1"), "INVALID_EXPRESSION plate radius");
}

TEST(Expression, TheLocaleOfTheProcessDoesNotMatter) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  bool comma = false;
  for (const char* name : {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8"})
    comma = comma || std::setlocale(LC_ALL, name) != nullptr;
  const double value = value_of("1.5*2");
  const std::string list = expression_failure("1,5");
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_EQ(value, 3) << (comma ? "decimal comma" : "no such locale here");
  EXPECT_EQ(list, "INVALID_EXPRESSION plate radius");
}

TEST(Expression, AnyJumbleOfTokensIsEitherAFiniteValueOrAnError) {
  const char* tokens[] = {"1",  "2.5", "a", "b",  "sin", "max", "(",   ")",   ",",
                          "+",  "-",   "*", "/",  "^",   "?",   ":",   "<",   ">",
                          "=",  "==",  "!", "&&", "||",  "pi",  " ",   "e",   ".",
                          "\"", "#",   "%", "1e", "_",   "sum", "(1)", "(a)", "?1:"};
  Random random(1);
  const Scope scope({{"a", 1.5}, {"b", "a*2"}});
  int values = 0;
  for (int k = 0; k < 20000; ++k) {
    std::string text;
    for (auto n = 1 + random.below(9); n > 0; --n) text += tokens[random.below(std::size(tokens))];
    try {
      EXPECT_TRUE(std::isfinite(scope.value(text, "plate", "radius"))) << text;
      ++values;
    } catch (const Error& e) {
      EXPECT_EQ(e.info().kind, ErrorKind::InvalidArgument) << text;
    }
  }
  EXPECT_GT(values, 500);
}

}  // namespace
}  // namespace remeshd
