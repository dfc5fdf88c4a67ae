#include "tests/bench/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace remeshd::bench {
namespace {

constexpr double kWidth = 760, kHeight = 480;
constexpr double kLeft = 70, kRight = 190, kTop = 44, kBottom = 56;  // margins
constexpr double kLineHeight = 17;
// Okabe & Ito: told apart by everyone.
constexpr std::array<const char*, 6> kColours{"#0072b2", "#d55e00", "#009e73",
                                              "#cc79a7", "#e69f00", "#56b4e9"};

/// A logarithmic axis from one pixel to another.
class Axis {
 public:
  Axis(double lo, double hi, double from, double to) : from_(from), to_(to) {
    const double margin = std::pow(hi / lo, 0.04) * 1.02;
    lo_ = std::log(lo / margin);
    hi_ = std::log(hi * margin);
  }
  [[nodiscard]] double at(double x) const {
    return from_ + (to_ - from_) * (std::log(x) - lo_) / (hi_ - lo_);
  }
  /// 1, 2, 5 times powers of ten; over more than three decades the powers alone.
  [[nodiscard]] std::vector<double> ticks() const {
    const bool many = hi_ - lo_ > 3 * std::log(10.0);
    std::vector<double> result;
    for (int k = static_cast<int>(std::floor(lo_ / std::log(10.0))); k <= hi_ / std::log(10.0); ++k)
      for (const double digit : {1.0, 2.0, 5.0}) {
        const double x = digit * std::pow(10.0, k);
        if ((many && digit > 1) || std::log(x) < lo_ || std::log(x) > hi_) continue;
        result.push_back(x);
      }
    return result;
  }

 private:
  double from_, to_, lo_ = 0, hi_ = 0;
};

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else
      out += c;
  }
  return out;
}

std::string text_at(double x, double y, const char* anchor, const std::string& words,
                    const std::string& more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                     anchor, more, escaped(words));
}

std::string line(double x1, double y1, double x2, double y2, const char* stroke) {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n", x1, y1, x2,
      y2, stroke);
}

/// A curve's name and where it wants to stand.
struct EndLabel {
  double y;
  std::string colour, name;
};

/// Moves labels down until none lies over the one before, then back up into the frame.
void part(std::vector<EndLabel>& labels) {
  std::ranges::sort(labels, {}, &EndLabel::y);
  for (std::size_t k = 1; k < labels.size(); ++k)
    labels[k].y = std::max(labels[k].y, labels[k - 1].y + kLineHeight);
  double most = kHeight - kBottom;
  for (std::size_t k = labels.size(); k-- > 0; most = labels[k].y - kLineHeight)
    labels[k].y = std::min(labels[k].y, most);
}

}  // namespace

std::string tick_label(double x) {
  if (x >= 1e6) return fmt::format("{:.4g}M", x / 1e6);
  if (x >= 1e3) return fmt::format("{:.4g}k", x / 1e3);
  return fmt::format("{:.4g}", x);
}

std::optional<double> exponent(const Curve& curve) {
  const double n = static_cast<double>(curve.points.size());
  if (n < 2) return {};
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (const auto& [x, y] : curve.points) {
    sx += std::log(x);
    sy += std::log(y);
    sxx += std::log(x) * std::log(x);
    sxy += std::log(x) * std::log(y);
  }
  const double spread = n * sxx - sx * sx;
  return spread > 0 ? std::optional((n * sxy - sx * sy) / spread) : std::nullopt;
}

std::string svg(const Plot& plot) {
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" font-family=\"sans-serif\" font-size=\"13\" fill=\"#222\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n",
      kWidth, kHeight);
  out += text_at(kLeft, 26, "start", plot.title, " font-size=\"16\"");
  double x_lo = HUGE_VAL, x_hi = 0, y_lo = HUGE_VAL, y_hi = 0;
  for (const Curve& curve : plot.curves)
    for (const auto& [x, y] : curve.points) {
      x_lo = std::min(x_lo, x);
      x_hi = std::max(x_hi, x);
      y_lo = std::min(y_lo, y);
      y_hi = std::max(y_hi, y);
    }
  if (x_hi > 0) {
    const double right = kWidth - kRight, bottom = kHeight - kBottom;
    const Axis x_axis(x_lo, x_hi, kLeft, right), y_axis(y_lo, y_hi, bottom, kTop);
    for (const double x : plot.x_ticks.empty() ? x_axis.ticks() : plot.x_ticks) {
      out += line(x_axis.at(x), kTop, x_axis.at(x), bottom, "#ddd");
      out += text_at(x_axis.at(x), bottom + 19, "middle", tick_label(x));
    }
    for (const double y : y_axis.ticks()) {
      out += line(kLeft, y_axis.at(y), right, y_axis.at(y), "#ddd");
      out += text_at(kLeft - 8, y_axis.at(y) + 4, "end", tick_label(y));
    }
    out += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#222\"/>\n",
        kLeft, kTop, right - kLeft, bottom - kTop);
    out += text_at(0.5 * (kLeft + right), kHeight - 14, "middle", plot.x_name);
    const double middle = 0.5 * (kTop + bottom);
    out += text_at(18, middle, "middle", plot.y_name,
                   fmt::format(" transform=\"rotate(-90 18 {:.1f})\"", middle));

    std::vector<EndLabel> labels;
    std::size_t colours = 0;
    for (const Curve& curve : plot.curves) {
      if (curve.points.empty()) continue;
      const std::string colour = curve.guide ? "#888" : kColours[colours++ % kColours.size()];
      std::string path;
      for (const auto& [x, y] : curve.points)
        path += fmt::format("{:.1f},{:.1f} ", x_axis.at(x), y_axis.at(y));
      path.pop_back();
      out += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" {}/>\n", path, colour,
                         curve.guide ? "stroke-dasharray=\"5 4\"" : "stroke-width=\"2\"");
      if (!curve.guide)
        for (const auto& [x, y] : curve.points)
          out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"{}\"/>\n",
                             x_axis.at(x), y_axis.at(y), colour);
      labels.push_back({y_axis.at(curve.points.back()[1]) + 4, colour, curve.name});
    }
    part(labels);
    for (const EndLabel& label : labels)
      out += text_at(right + 8, label.y, "start", label.name,
                     fmt::format(" style=\"fill:{}\"", label.colour));
  }
  return out + "</svg>\n";
}

}  // namespace remeshd::bench
