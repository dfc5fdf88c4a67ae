#include "engine/delivery/quality_drift.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "engine/nodes/density.h"

namespace remeshd {
namespace {

constexpr QualityReference kMostDrift{.volume_length_mean = 0.005, .nodes_over_expected = 0.1};
/// Adding or removing a detail alone changes the mean by a quarter of this, a sweep of a plate's
/// thickness by half of it within five steps; new meshes of Gmsh HXT lie below ours by twice as
/// much (tests/bench/sized.md). A chain of edits keeps its nodes until then.
constexpr QualityReference kMostSizedDrift{.volume_length_mean = 0.04};

}  // namespace

QualityReference quality_reference(const Revision& revision) {
  // What a base size lets one expect says nothing of a mesh whose details ask for shorter edges.
  if (!revision.options.sizing.even) return {revision.report.quality.volume_length_mean, 1};
  return {revision.report.quality.volume_length_mean,
          static_cast<double>(revision.report.counts.nodes) /
              expected_nodes(revision.cells.volume, revision.cells.area, revision.edge_length)};
}

bool is_regular(const Revision& revision) {
  return revision.reference.volume_length_mean == revision.report.quality.volume_length_mean;
}

bool has_drifted(const QualityReference& now, const QualityReference& then, bool even) {
  const double most_lost =
      even ? kMostDrift.volume_length_mean : kMostSizedDrift.volume_length_mean;
  return now.volume_length_mean < then.volume_length_mean - most_lost ||
         std::fabs(now.nodes_over_expected / then.nodes_over_expected - 1) >
             kMostDrift.nodes_over_expected;
}

std::string describe(const QualityReference& reference) {
  std::array<char, 96> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.3f mean volume-length, %.2f of the nodes expected",
                reference.volume_length_mean, reference.nodes_over_expected);
  return buffer.data();
}

}  // namespace remeshd
