#include "engine/optimise/optimise.h"

#include <algorithm>

#include "engine/kernel/delaunay.h"
#include "engine/nodes/nearest.h"
#include "engine/optimise/active_samples.h"
#include "engine/optimise/pull.h"
#include "engine/optimise/recover.h"
#include "engine/optimise/relocate.h"

namespace remeshd {

namespace {

/// Builds the Delaunay mesh of the fixed and the free nodes, again and again while the free ones
/// move: fixed nodes beyond the reach of any expansion are inserted once, the other fixed ones once
/// for every set of free nodes, the free ones every time.
class Triangulator {
 public:
  Triangulator(const NodeSet& nodes, std::vector<std::uint8_t>& may_be_free, const Box& bounds,
               const Run& run)
      : may_be_free_(may_be_free), empty_(bounds), far_(bounds), fixed_(bounds), run_(run) {
    build_far(nodes);
    fix(nodes);
  }

  /// Call whenever the set of free nodes has changed by more than new nodes.
  void fix(const NodeSet& nodes) {
    bool beyond = false;  // a vertex has claimed a node that no expansion would have reached
    for (std::size_t n = 0; n < may_be_free_.size(); ++n) {
      if (!nodes.free[n] || may_be_free_[n]) continue;
      may_be_free_[n] = 1;
      beyond = true;
    }
    if (beyond) build_far(nodes);
    fixed_ = far_;
    std::vector<std::int32_t> fixed;
    for (std::int32_t n = 0; n < static_cast<std::int32_t>(may_be_free_.size()); ++n)
      if (may_be_free_[n] && !nodes.free[n]) fixed.push_back(n);
    fixed_.insert(nodes.positions, fixed, run_);
  }

  std::vector<Tet> tets(const NodeSet& nodes) const {
    kernel::Delaunay mesh = fixed_;
    std::vector<std::int32_t> free;
    for (std::int32_t n = 0; n < nodes.size(); ++n)
      if (nodes.free[n]) free.push_back(n);
    mesh.insert(nodes.positions, free, run_);
    std::vector<Tet> tets;
    tets.reserve(mesh.size());
    mesh.for_each_tet([&](const Tet& t) { tets.push_back(t); });
    return tets;
  }

 private:
  void build_far(const NodeSet& nodes) {
    far_ = empty_;
    std::vector<std::int32_t> never;
    for (std::int32_t n = 0; n < static_cast<std::int32_t>(may_be_free_.size()); ++n)
      if (!may_be_free_[n]) never.push_back(n);
    far_.insert(nodes.positions, never, run_);
  }

  std::vector<std::uint8_t>& may_be_free_;
  const kernel::Delaunay empty_;
  kernel::Delaunay far_, fixed_;
  const Run& run_;
};

/// Nodes that are free or within `radius` of one that is.
std::vector<std::uint8_t> within_reach(const NodeSet& nodes, double radius) {
  std::vector<std::uint8_t> reach(nodes.free.begin(), nodes.free.end());
  std::vector<Vec3> free;
  for (std::int32_t n = 0; n < nodes.size(); ++n)
    if (nodes.free[n]) free.push_back(nodes.positions[n]);
  if (free.size() == nodes.positions.size()) return reach;
  const NearestNode grid(free, 0.5 * radius);
  for (std::int32_t n = 0; n < nodes.size(); ++n) {
    if (reach[n]) continue;
    const std::int32_t f = grid.nearest(nodes.positions[n]);
    reach[n] = f >= 0 && norm2(free[f] - nodes.positions[n]) <= radius * radius;
  }
  return reach;
}

/// Frees the fixed nodes next to free ones, through tets that belong to the model: such as have an
/// interior node or, all corners being on the boundary, their centroid inside (Sect. 8).
bool expand(NodeSet& nodes, const std::vector<Tet>& tets,
            const std::vector<std::uint8_t>& may_be_free, const Membership& membership) {
  const std::vector<std::uint8_t> was_free = nodes.free;
  bool grown = false;
  for (const Tet& t : tets) {
    const int free = was_free[t[0]] + was_free[t[1]] + was_free[t[2]] + was_free[t[3]];
    if (free == 0 || free == 4) continue;
    const bool interior = std::any_of(t.begin(), t.end(), [&](std::int32_t n) {
      return nodes.supports[n].kind == Support::Kind::Interior;
    });
    if (!interior && !membership.inside(0.25 * (nodes.positions[t[0]] + nodes.positions[t[1]] +
                                                nodes.positions[t[2]] + nodes.positions[t[3]])))
      continue;
    for (const std::int32_t n : t) {
      if (nodes.free[n] || static_cast<std::size_t>(n) >= may_be_free.size() || !may_be_free[n])
        continue;
      nodes.free[n] = 1;
      grown = true;
    }
  }
  return grown;
}

std::uint32_t count_free(const NodeSet& nodes) {
  return static_cast<std::uint32_t>(std::count(nodes.free.begin(), nodes.free.end(), 1));
}

}  // namespace

OptimiseResult optimise(NodeSet& nodes, const BoundaryModel& boundary, const Membership& membership,
                        const Samples& samples, const OptimiseOptions& options, const Run& run) {
  OptimiseResult result;
  const Adjacency adjacency(boundary);
  const PullOptions pull{.edge_length = options.edge_length};
  const bool all_free = count_free(nodes) == static_cast<std::uint32_t>(nodes.size());
  ActiveSamples active =
      all_free ? ActiveSamples(samples) : ActiveSamples(samples, nodes, options.edge_length);
  std::vector<std::uint8_t> may_be_free = within_reach(nodes, options.reach * options.edge_length);
  Triangulator triangulator(nodes, may_be_free, boundary.bounds, run);

  const std::uint32_t last = options.iterations ? options.iterations : options.auto_max;
  double quality = 0;
  for (std::uint32_t k = 1; k <= last; ++k) {
    run.report("optimise", 0.15 + 0.6 * (k - 1) / last, static_cast<int>(k));
    const std::uint32_t free_before = count_free(nodes);
    const std::int32_t size_before = nodes.size();
    active.promote(
        pull_boundary(nodes, boundary, adjacency, samples, active.participants(), pull, run));
    if (count_free(nodes) - free_before != static_cast<std::uint32_t>(nodes.size() - size_before))
      triangulator.fix(nodes);
    result.free_per_iteration.push_back(count_free(nodes));
    result.tets = triangulator.tets(nodes);
    const double now = relocate(nodes, result.tets, membership);
    if ((k == 1 || k == 4) && !all_free && expand(nodes, result.tets, may_be_free, membership)) {
      triangulator.fix(nodes);
      active.refresh(nodes);
    }
    if (options.iterations == 0 && k >= options.auto_min && now - quality < options.auto_gain)
      break;
    quality = now;
  }
  active.promote(
      pull_boundary(nodes, boundary, adjacency, samples, active.participants(), pull, run));
  result.tets = triangulator.tets(nodes);
  result.nodes_recovered =
      recover_edges(nodes, boundary, result.tets, [&] { return triangulator.tets(nodes); },
                    {.edge_length = options.edge_length});
  result.samples_active = active.active_count();
  return result;
}

}  // namespace remeshd
