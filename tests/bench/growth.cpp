#include "tests/bench/growth.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "tests/support/cases.h"

namespace remeshd::bench {
namespace {

constexpr double kSide = 160, kThickness = 8;  // mm, of the plate
constexpr double kRadius = 2.5, kPin = 6;      // mm, of holes and pins; height of pins
constexpr double kShift = 1.5;                 // mm

/// One curve a series, named with the exponent it grows by, and what is linear beside the first.
void add_curves(Plot& plot,
                const std::function<std::optional<double>(const std::string&, std::size_t)>& at,
                const std::vector<double>& xs) {
  for (const std::string run : {"regular", "remesh"}) {
    Curve curve{.name = run, .points = {}};
    for (std::size_t k = 0; k < xs.size(); ++k)
      if (const std::optional<double> y = at(series_name(run, 10), k))
        curve.points.push_back({xs[k], *y});
    if (const std::optional<double> p = exponent(curve))
      curve.name += fmt::format(", x^{:.2f}", *p);
    plot.curves.push_back(std::move(curve));
  }
}

}  // namespace

std::string hole_plate_name(int features) { return "plate-" + std::to_string(features); }

Subject hole_plate(int features) {
  const int sites = features - 1;
  const int per_side = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(sites))));
  const double pitch = kSide / per_side;
  const auto coordinate = [&](int k) { return (k + 0.5) * pitch - 0.5 * kSide; };
  std::vector<FeatureSource> parts{test::block("plate", kSide, kSide, kThickness)};
  for (int k = 0; k < sites; ++k) {
    const int row = k / per_side, column = k % per_side;
    const bool hole = (row + column) % 2 == 0;
    const double x = coordinate(column), y = coordinate(row);
    const std::string id = (hole ? "hole" : "pin") + std::to_string(k + 1);
    parts.push_back(
        hole ? test::placed(test::cylinder(id, kRadius, kThickness), x, y, 0, Nature::Subtractive)
             : test::placed(test::cylinder(id, kRadius, kPin), x, y, kThickness));
  }
  const ModelSource original = test::model_of(parts);
  FeatureSource& moved = parts[1 + sites / 2];
  moved.placement.origin[0] = std::get<double>(moved.placement.origin[0]) + kShift;
  return {hole_plate_name(features), original, test::model_of(parts)};
}

Plot plot_nodes(const Results& results, const GrowthPoints& points) {
  Plot plot{.title = "Time against nodes: simple-ab, 10 iterations",
            .x_name = "nodes",
            .y_name = "processor time, s",
            .curves = {},
            .x_ticks = {points.nodes.begin(), points.nodes.end()}};
  add_curves(
      plot,
      [&](const std::string& series, std::size_t k) -> std::optional<double> {
        const Group* group = results.find("simple-ab", points.nodes[k]);
        return group ? group->seconds(series) : std::nullopt;
      },
      plot.x_ticks);
  const Curve& regular = plot.curves.front();
  if (regular.points.size() > 1) {
    const auto [x0, y0] = regular.points.front();
    const double x1 = regular.points.back()[0];
    plot.curves.push_back(
        {.name = "linear", .points = {{x0, y0}, {x1, y0 * x1 / x0}}, .guide = true});
  }
  return plot;
}

Plot plot_features(const Results& results, const GrowthPoints& points) {
  Plot plot{.title = fmt::format("Time against features: a plate of {} nodes, 10 iterations",
                                 tick_label(points.nodes_of_features)),
            .x_name = "features",
            .y_name = "processor time, s",
            .curves = {},
            .x_ticks = {points.features.begin(), points.features.end()}};
  add_curves(
      plot,
      [&](const std::string& series, std::size_t k) -> std::optional<double> {
        const Group* group =
            results.find(hole_plate_name(points.features[k]), points.nodes_of_features);
        return group ? group->seconds(series) : std::nullopt;
      },
      plot.x_ticks);
  return plot;
}

}  // namespace remeshd::bench
