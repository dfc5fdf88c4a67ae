#include "engine/optimise/optimise.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/mesh/grouping.h"
#include "engine/nodes/dump.h"
#include "engine/optimise/active_samples.h"
#include "engine/optimise/large_circumballs.h"
#include "engine/optimise/live_mesh.h"
#include "engine/optimise/node_lengths.h"
#include "engine/optimise/pull.h"
#include "engine/optimise/relocate.h"

namespace remeshd {

namespace {

constexpr std::uint32_t kFillAt = 3;    // iteration: by then gaps that are no voids have closed
constexpr std::uint32_t kAtFirst = 2;   // iterations with a reach, where walls are thin
constexpr double kReachAtFirst = 0.55;  // x edge length: how far the boundary pulls in these

/// `07-optimise-04`.
std::string dump_name(std::uint32_t iteration) {
  return (iteration < 10 ? "07-optimise-0" : "07-optimise-") + std::to_string(iteration);
}

/// Freezes the free nodes that are less than a share of their edge length from where they were.
void freeze(NodeSet& nodes, const std::vector<Vec3>& before, double share,
            const NodeLengths& lengths) {
  for (std::size_t n = 0; n < before.size(); ++n) {
    if (nodes.state[n] != NodeState::Free) continue;
    const double distance = share * lengths[n];
    if (norm2(nodes.positions[n] - before[n]) < distance * distance)
      nodes.state[n] = NodeState::Frozen;
  }
}

void thaw_boundary(NodeSet& nodes) {
  for (std::int32_t n = 0; n < nodes.size(); ++n)
    if (nodes.state[n] == NodeState::Frozen && nodes.supports[n].kind != Support::Kind::Interior)
      nodes.state[n] = NodeState::Free;
}

/// Frees the fixed nodes next to free ones, through tets that belong to the model: such as have an
/// interior node or, all corners being on the boundary, their centroid inside (Sect. 8). Nodes at
/// a patch's interface stay. Returns whether any was freed.
bool expand(NodeSet& nodes, const std::vector<Tet>& tets, const InsideTest& inside) {
  const std::vector<NodeState> before = nodes.state;
  const auto fixed = [&](std::int32_t n) { return before[n] == NodeState::Fixed; };
  bool grown = false;
  for (const Tet& t : tets) {
    const auto stay = std::ranges::count_if(t, fixed);
    if (stay == 0 || stay == 4) continue;
    const bool interior = std::any_of(t.begin(), t.end(), [&](std::int32_t n) {
      return nodes.supports[n].kind == Support::Kind::Interior;
    });
    if (!interior && !inside(centroid(nodes.positions, t))) continue;
    for (const std::int32_t n : t) {
      if (!fixed(n) || n < nodes.interface_nodes) continue;
      nodes.state[n] = NodeState::Free;
      grown = true;
    }
  }
  return grown;
}

/// Model edges with active or border-active samples, ascending.
std::vector<std::int32_t> active_edges(const Samples& samples, const ActiveSamples& active) {
  std::vector<std::int32_t> edges;
  for (const std::uint32_t s : active.participants())
    if (const Support& on = samples.points[s].support; on.kind == Support::Kind::Edge)
      edges.push_back(on.entity);
  sort_unique(edges);
  return edges;
}

}  // namespace

OptimiseResult optimise(NodeSet& nodes, StartMesh start, const BoundaryModel& boundary,
                        const InsideTest& inside, const Samples& samples,
                        const OptimiseOptions& options, const Run& run) {
  OptimiseResult result;
  const Adjacency adjacency(boundary);
  const PullOptions pull{.sizes = options.sizes};
  PullOptions pull_at_first = pull;
  if (options.thin_walls) pull_at_first.reach = kReachAtFirst;
  const bool all_free = nodes.count(NodeState::Free) == nodes.positions.size();
  NearestToPoints nearest(samples.positions(), kGridCell * options.sizes.grid_length());
  ActiveSamples active =
      all_free ? ActiveSamples(samples) : ActiveSamples(nodes, options.sizes, nearest, run);
  NodeLengths lengths(options.sizes);
  LiveMesh live(std::move(start.mesh), std::move(start.holds), options.rebuild, run);
  const auto pull_in = [&](const PullOptions& how) {
    active.promote(pull_boundary(nodes, boundary, adjacency, samples, active.participants(),
                                 nearest, how, run));
  };

  const std::uint32_t last = options.iterations ? options.iterations : options.auto_max;
  double quality = 0;
  for (std::uint32_t k = 1; k <= last; ++k) {
    run.report("optimise", 0.15 + 0.6 * (k - 1) / last, static_cast<int>(k));
    const std::vector<Vec3> before = nodes.positions;
    pull_in(k <= kAtFirst ? pull_at_first : pull);
    live.follow(nodes);
    result.free_per_iteration.push_back(nodes.count(NodeState::Free) +
                                        nodes.count(NodeState::Frozen));
    if (!run.dumps.empty()) dump_nodes(run, dump_name(k), nodes, options.sizes, live.tets());
    const std::vector<Tet> tets = live.tets_at(relocated(nodes));
    const double now = options.iterations == 0 ? mean_quality(nodes, tets, run) : 0;
    const bool filled =
        std::isfinite(options.largest_ball) && k == kFillAt &&
        insert_at_circumcentres(nodes, tets, inside, options.sizes, options.largest_ball) > 0;
    lengths.follow(nodes.positions, run);
    relocate(nodes, tets, inside, lengths, run);
    lengths.follow(nodes.positions, run);
    freeze(nodes, before, options.freeze, lengths);
    if ((k == 1 || (k == 4 && options.sizes.even())) && !all_free &&
        expand(nodes, live.tets(), inside))
      active.refresh(nodes, run);
    if (options.iterations == 0 && k >= options.auto_min && now - quality < options.auto_gain)
      break;
    quality = filled ? 0 : now;  // new nodes lower the quality at first: do not stop
  }
  thaw_boundary(nodes);
  pull_in(pull);
  live.follow(nodes);
  result.mesh = live.mesh();
  result.active_edges = active_edges(samples, active);
  std::ranges::replace(nodes.state, NodeState::Frozen, NodeState::Free);
  result.samples_active = active.active_count();
  return result;
}

}  // namespace remeshd
