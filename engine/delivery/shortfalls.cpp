#include "engine/delivery/shortfalls.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace remeshd {
namespace {

struct WarningLimits {
  double off_target = 0.1;      ///< of the nodes asked for
  double least_reached = 0.98;  ///< x the clean-up's aim: a quality above this gets no warning
  /// x edge length. A circle is 0.13 edge lengths from its edges where it has six, 0.21 where it
  /// has four, 0.29 where it has three; facets have edges half as long again.
  double coarse_chord = 0.25;
};
constexpr WarningLimits kWarningLimits;

std::string digits(double value, int count) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.*g", count, value);
  return text.data();
}

Warning warning(WarningCode code, std::string message) {
  return {.code = code, .message = std::move(message)};
}

}  // namespace

std::vector<Warning> shortfalls(const Revision& made) {
  std::vector<Warning> warnings;
  const Report& report = made.report;
  if (made.options.nodes) {
    const double asked = *made.options.nodes;
    if (std::fabs(report.counts.nodes - asked) > kWarningLimits.off_target * asked)
      warnings.push_back(warning(WarningCode::NodesFarFromTarget,
                                 "the mesh has " + std::to_string(report.counts.nodes) +
                                     " nodes where " + std::to_string(*made.options.nodes) +
                                     " were asked for"));
  }
  const double least = report.quality_away.volume_length_min;
  if (made.options.clean_up && least < kWarningLimits.least_reached * made.options.threshold)
    warnings.push_back(warning(WarningCode::QualityLow,
                               "the least volume-length away from sharp places of the model is " +
                                   digits(least, 3) + ", where the clean-up aims at " +
                                   digits(made.options.threshold, 3)));
  const double chord = report.verification.chord_error;
  if (chord > kWarningLimits.coarse_chord * made.edge_length)
    warnings.push_back(
        warning(WarningCode::ChordsCoarse, "chords lie up to " + digits(chord, 3) +
                                               " off their curved faces, at an edge length of " +
                                               digits(made.edge_length, 3)));
  if (const std::uint32_t straight = report.counts.straight_edges; straight > 0)
    warnings.push_back(
        warning(WarningCode::EdgesStraight,
                std::to_string(straight) + " of " + std::to_string(report.counts.mid_nodes) +
                    " mid-nodes lie off their curved faces, in the middle of straight "
                    "edges: curved ones would turn tets over"));
  return warnings;
}

}  // namespace remeshd
