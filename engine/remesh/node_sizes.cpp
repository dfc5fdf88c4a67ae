#include "engine/remesh/node_sizes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "engine/base/parallel.h"
#include "engine/revision/delaunay_state.h"

namespace remeshd {
namespace {

constexpr double kMostOff = 1.25;  // of a length wanted and one that was
constexpr double kAround = 0.75;   // x edge length, of what is made anew with a node
constexpr int kSteps = 2;          // cubes to that

bool differ(double a, double b) { return a > kMostOff * b || b > kMostOff * a; }

/// Whether that is known: revisions that are not even were stored without it once.
bool is_known(const Revision& parent) {
  return parent.options.sizing.even || !parent.node_sizes.empty();
}

/// What the parent's node was made for.
double made_for(const Revision& parent, std::int32_t node) {
  return parent.options.sizing.even ? parent.edge_length : parent.node_sizes[node];
}

/// Whether the tets of the parent were kept, wherever their nodes went.
bool keeps_tets(const Revision& revision) {
  const MeshStrategy strategy = revision.report.strategy;
  return strategy == MeshStrategy::Unchanged || strategy == MeshStrategy::Morphed;
}

}  // namespace

CowVector<double> made_for(const Revision& parent, const Revision& revision, const Run& run) {
  if (revision.options.sizing.even) return {};
  const OutputMesh& output = revision.output;
  const SizeField& sizes = *revision.sizes;
  const CowVector<Vec3>& positions = revision.delaunay_state->positions();  // as it is asked later
  const bool known = is_known(parent), same_tets = keeps_tets(revision);
  std::vector<double> all(output.mesh.nodes.size());
  in_blocks(all.size(), kDearBlock, run, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
      all[n] = known && (same_tets || output.map.node_origin[n] == NodeOrigin::Kept)
                   ? made_for(parent, output.map.original_node[n])
                   : sizes(positions[n]);
  });
  return {std::span<const double>(all), parent.node_sizes};
}

std::vector<Region> resized_places(const Revision& parent, const Revision& wanted,
                                   const SizeField& sizes, const CopyPlan& plan, const Run& run) {
  if (wanted.options.sizing.even && parent.options.sizing.even) return {};
  if (!is_known(parent) || plan.identity() < 0 || !plan.copies()) return {};
  const CowVector<Vec3>& nodes = parent.delaunay_state->positions();
  struct Resized {
    Vec3 at;
    double size;
  };
  const std::vector<Resized> resized = collect_in_blocks<Resized>(
      nodes.size(), kDearBlock, run,
      [&](std::size_t begin, std::size_t end, std::vector<Resized>& found) {
        for (std::size_t n = begin; n < end; ++n) {
          const double then = made_for(parent, static_cast<std::int32_t>(n));
          const double now = sizes(nodes[n]);
          if (differ(then, now)) found.push_back({nodes[n], std::fmax(then, now)});
        }
      });
  // Regions of one reach each: lengths within an octave.
  std::map<int, std::pair<std::vector<Vec3>, double>> by_size;
  for (const Resized& r : resized) {
    auto& [points, longest] = by_size[std::ilogb(r.size)];
    points.push_back(r.at);
    longest = std::fmax(longest, r.size);
  }
  std::vector<Region> regions;
  regions.reserve(by_size.size());
  for (const auto& [octave, of_it] : by_size)
    regions.emplace_back(of_it.first, kAround * of_it.second, kSteps);
  return regions;
}

}  // namespace remeshd
