#include "tests/bench/plot.h"

#include <gmock/gmock.h>

#include <regex>

namespace remeshd::bench {
namespace {

using testing::DoubleNear;
using testing::HasSubstr;
using testing::Not;
using testing::Optional;

Plot example_plot() {
  return {.title = "Time & nodes",
          .x_name = "nodes",
          .y_name = "s",
          .curves = {{.name = "regular", .points = {{15e3, .4}, {1e5, 3}, {1e6, 35}}},
                     {.name = "remesh", .points = {{15e3, .1}, {1e5, .4}, {1e6, 3}}},
                     {.name = "linear", .points = {{15e3, .4}, {1e6, 26.7}}, .guide = true}}};
}

std::vector<double> numbers(const std::string& text, const std::string& pattern) {
  std::vector<double> found;
  const std::regex expression(pattern);
  for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it)
    found.push_back(std::stod((*it)[1]));
  return found;
}

TEST(Svg, HasEveryPointInsideTheFrame) {
  const std::string text = svg(example_plot());
  const std::vector<double> x = numbers(text, "cx=\"([0-9.]+)\"");
  const std::vector<double> y = numbers(text, "cy=\"([0-9.]+)\"");
  ASSERT_EQ(x.size(), 6U);
  EXPECT_THAT(x, testing::Each(testing::AllOf(testing::Gt(70), testing::Lt(570))));
  EXPECT_THAT(y, testing::Each(testing::AllOf(testing::Gt(44), testing::Lt(424))));
  EXPECT_LT(x[0], x[2]);
  EXPECT_GT(y[0], y[2]);  // upwards
}

TEST(Svg, EqualFactorsAreEqualDistances) {
  const Plot plot{.curves = {{.name = "a", .points = {{1, 1}, {10, 100}, {100, 1e4}}}}};
  const std::string text = svg(plot);
  const std::vector<double> x = numbers(text, "cx=\"([0-9.]+)\"");
  const std::vector<double> y = numbers(text, "cy=\"([0-9.]+)\"");
  EXPECT_NEAR(x[1] - x[0], x[2] - x[1], 0.11);
  EXPECT_NEAR(y[1] - y[0], y[2] - y[1], 0.11);
}

TEST(Svg, NamesAxesAndCurvesAndEscapesThem) {
  const std::string text = svg(example_plot());
  for (const char* words : {"Time &amp; nodes", ">nodes<", ">s<", ">regular<", ">remesh<", ">20k<",
                            ">1M<", "stroke-dasharray"})
    EXPECT_THAT(text, HasSubstr(words));
  EXPECT_THAT(text, Not(HasSubstr("Time & nodes")));
}

TEST(Svg, TicksStandWhereTheyAreAskedFor) {
  Plot plot = example_plot();
  plot.x_ticks = {15e3, 1e6};
  const std::string text = svg(plot);
  EXPECT_THAT(text, HasSubstr(">15k<"));
  EXPECT_THAT(text, Not(HasSubstr(">20k<")));
}

TEST(Svg, NamesOfCurvesThatEndTogetherDoNotOverlap) {
  Plot plot;
  for (const char* name : {"a", "b", "c"})
    plot.curves.push_back({.name = name, .points = {{1, 1}, {10, 1.001}}});
  plot.curves.push_back({.name = "far", .points = {{1, 50}, {10, 80}}});
  const std::vector<double> y = numbers(svg(plot), "x=\"578.0\" y=\"([0-9.]+)\"");
  ASSERT_EQ(y.size(), 4U);
  for (std::size_t k = 1; k < y.size(); ++k) EXPECT_GE(y[k] - y[k - 1], 16.9);
  EXPECT_LE(y.back(), 424);
}

TEST(Svg, APlotWithoutPointsIsADocumentStill) {
  EXPECT_THAT(svg({.title = "empty"}), HasSubstr("</svg>"));
  EXPECT_THAT(svg({.curves = {{.name = "one", .points = {{5, 5}}}}}), Not(HasSubstr("nan")));
}

TEST(Exponent, IsThatOfThePowerLaw) {
  EXPECT_THAT(exponent({.points = {{1, 3}, {10, 300}, {100, 3e4}}}), Optional(DoubleNear(2, 1e-9)));
  EXPECT_EQ(exponent({.points = {{1, 3}}}), std::nullopt);
  EXPECT_EQ(exponent({.points = {{5, 3}, {5, 4}}}), std::nullopt);
}

TEST(TickLabel, IsShort) {
  EXPECT_EQ(tick_label(0.05), "0.05");
  EXPECT_EQ(tick_label(200), "200");
  EXPECT_EQ(tick_label(2000), "2k");
  EXPECT_EQ(tick_label(15000), "15k");
  EXPECT_EQ(tick_label(1e6), "1M");
}

}  // namespace
}  // namespace remeshd::bench
