#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace remeshd::bench {

/// Points (x, y), all positive, in ascending order of x.
struct Curve {
  std::string name;
  std::vector<std::array<double, 2>> points;
  bool guide = false;  ///< a thin dashed line to compare others with
};

/// A diagram with logarithmic axes.
struct Plot {
  std::string title, x_name, y_name;
  std::vector<Curve> curves;
  std::vector<double> x_ticks;  ///< empty: 1, 2, 5 times powers of ten
};

/// The plot as an SVG document. Every curve is named at its right end.
std::string svg(const Plot& plot);

/// The exponent p of the power law c x^p that fits a curve best; nothing for fewer than two points.
std::optional<double> exponent(const Curve& curve);

/// A tick's number in few characters: `0.05`, `15k`, `1M`.
std::string tick_label(double x);

}  // namespace remeshd::bench
