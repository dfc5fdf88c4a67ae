#include "engine/remesh/node_sizes.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "engine/base/parallel.h"
#include "engine/base/region.h"
#include "engine/nodes/nearest.h"
#include "engine/revision/delaunay_state.h"

namespace remeshd {
namespace {

struct ResizeLimits {
  double most_off = 1.25;  ///< of a length wanted and one that was
  double around = 1;       ///< x edge length: nothing nearest to a node is further away
};
constexpr ResizeLimits kResizeLimits;

bool differ(double a, double b) {
  return a > kResizeLimits.most_off * b || b > kResizeLimits.most_off * a;
}

/// Whether that is known: revisions that are not even were stored without it once.
bool is_known(const Revision& parent) {
  return parent.options.sizing.even || !parent.output.node_sizes.empty();
}

/// What the parent's node was made for.
double made_for(const Revision& parent, std::int32_t node) {
  return parent.options.sizing.even ? parent.edge_length : parent.output.node_sizes[node];
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
    for (std::size_t n = begin; n < end; ++n) {
      const bool kept = known && (same_tets || output.map.node_origin[n] == NodeOrigin::Kept);
      const double was = kept ? made_for(parent, output.map.original_node[n]) : 0;
      // What was off has been looked at: a node that stays is right for the length there.
      const bool as_before = kept && (same_tets || !differ(was, sizes(positions[n])));
      all[n] = as_before ? was : sizes(positions[n]);
    }
  });
  return {std::span<const double>(all), parent.output.node_sizes};
}

std::optional<CopyPlan> resized(const CopyPlan& plan, const Revision& parent,
                                const Revision& wanted, const SizeField& sizes, const Run& run) {
  if (wanted.options.sizing.even && parent.options.sizing.even) return {};
  if (!is_known(parent) || plan.identity() < 0 || !plan.copies()) return {};
  const std::vector<Vec3> nodes = parent.delaunay_state->positions().flat();
  std::vector<std::uint8_t> off(nodes.size());
  in_blocks(nodes.size(), kDearBlock, run, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
      off[n] = differ(made_for(parent, static_cast<std::int32_t>(n)), sizes(nodes[n])) ? 1 : 0;
  });
  std::vector<Vec3> places;
  double longest = 0;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (off[n] == 0) continue;
    places.push_back(nodes[n]);
    longest = std::max({longest, made_for(parent, static_cast<std::int32_t>(n)), sizes(nodes[n])});
  }
  if (places.empty()) return {};
  struct Nearest {
    NearestNode grid;
    std::vector<std::uint8_t> off;
  };
  const auto nearest = std::make_shared<const Nearest>(
      Nearest{NearestNode(nodes, kGridCell * sizes.grid_length()), std::move(off)});
  return plan.with_new_in(
      [nearest](const Vec3& p) { return nearest->off[nearest->grid.nearest(p)] != 0; },
      Region(places, kResizeLimits.around * longest, 1).boxes(), CopyPlan::Anew::InPlace);
}

}  // namespace remeshd
