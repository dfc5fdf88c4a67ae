#include "engine/optimise/optimise.h"

#include <algorithm>
#include <string>

#include "engine/nodes/dump.h"
#include "engine/optimise/active_samples.h"
#include "engine/optimise/large_circumballs.h"
#include "engine/optimise/live_mesh.h"
#include "engine/optimise/pull.h"
#include "engine/optimise/recover.h"
#include "engine/optimise/relocate.h"

namespace remeshd {

namespace {

constexpr std::uint32_t kFillAt = 3;  // iteration: by then what is no void has closed

/// `07-optimise-04`.
std::string dump_name(std::uint32_t iteration) {
  return (iteration < 10 ? "07-optimise-0" : "07-optimise-") + std::to_string(iteration);
}

std::uint32_t count_free(const NodeSet& nodes) {
  return static_cast<std::uint32_t>(std::count(nodes.free.begin(), nodes.free.end(), 1));
}

/// Free nodes that have come to rest.
class Frozen {
 public:
  /// Freezes the free nodes that are less than `distance` from where they were.
  void freeze(NodeSet& nodes, const std::vector<Vec3>& before, double distance) {
    frozen_.resize(nodes.positions.size(), 0);
    for (std::size_t n = 0; n < before.size(); ++n) {
      if (!nodes.free[n] || norm2(nodes.positions[n] - before[n]) >= distance * distance) continue;
      frozen_[n] = 1;
      nodes.free[n] = 0;
      ++count_;
    }
  }
  void thaw_boundary(NodeSet& nodes) {
    for (std::size_t n = 0; n < frozen_.size(); ++n)
      if (frozen_[n] && nodes.supports[n].kind != Support::Kind::Interior) nodes.free[n] = 1;
  }
  void thaw_all(NodeSet& nodes) {
    for (std::size_t n = 0; n < frozen_.size(); ++n)
      if (frozen_[n]) nodes.free[n] = 1;
  }
  [[nodiscard]] bool holds(std::int32_t n) const {
    return static_cast<std::size_t>(n) < frozen_.size() && frozen_[n];
  }
  [[nodiscard]] std::uint32_t count() const { return count_; }

 private:
  std::vector<std::uint8_t> frozen_;
  std::uint32_t count_ = 0;
};

/// Frees the fixed nodes next to free ones, through tets that belong to the model: such as have an
/// interior node or, all corners being on the boundary, their centroid inside (Sect. 8). Nodes at
/// a patch's interface stay.
bool expand(NodeSet& nodes, const Frozen& frozen, const std::vector<Tet>& tets,
            const InsideTest& inside) {
  std::vector<std::uint8_t> was_free = nodes.free;
  for (std::int32_t n = 0; n < nodes.size(); ++n) was_free[n] |= frozen.holds(n);
  bool grown = false;
  for (const Tet& t : tets) {
    const int free = was_free[t[0]] + was_free[t[1]] + was_free[t[2]] + was_free[t[3]];
    if (free == 0 || free == 4) continue;
    const bool interior = std::any_of(t.begin(), t.end(), [&](std::int32_t n) {
      return nodes.supports[n].kind == Support::Kind::Interior;
    });
    if (!interior && !inside(0.25 * (nodes.positions[t[0]] + nodes.positions[t[1]] +
                                     nodes.positions[t[2]] + nodes.positions[t[3]])))
      continue;
    for (const std::int32_t n : t) {
      if (was_free[n] || n < nodes.interface_nodes) continue;
      nodes.free[n] = 1;
      grown = true;
    }
  }
  return grown;
}

/// Model edges with samples that take part, ascending.
std::vector<std::int32_t> active_edges(const Samples& samples, const ActiveSamples& active) {
  std::vector<std::int32_t> edges;
  for (const std::uint32_t s : active.participants())
    if (const Support& on = samples.points[s].support; on.kind == Support::Kind::Edge)
      edges.push_back(on.entity);
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace

OptimiseResult optimise(NodeSet& nodes, StartMesh start, const BoundaryModel& boundary,
                        const InsideTest& inside, const Samples& samples,
                        const OptimiseOptions& options, const Run& run) {
  OptimiseResult result;
  const Adjacency adjacency(boundary);
  const PullOptions pull{.edge_length = options.edge_length};
  const bool all_free = count_free(nodes) == static_cast<std::uint32_t>(nodes.size());
  NearestToPoints nearest(samples.positions(), kGridCell * options.edge_length);
  ActiveSamples active =
      all_free ? ActiveSamples(samples) : ActiveSamples(nodes, options.edge_length, nearest, run);
  LiveMesh live(std::move(start.mesh), std::move(start.holds), options.rebuild, run);
  Frozen frozen;
  const auto pull_now = [&] {
    active.promote(pull_boundary(nodes, boundary, adjacency, samples, active.participants(),
                                 nearest, pull, run));
  };

  const std::uint32_t last = options.iterations ? options.iterations : options.auto_max;
  double quality = 0;
  for (std::uint32_t k = 1; k <= last; ++k) {
    run.report("optimise", 0.15 + 0.6 * (k - 1) / last, static_cast<int>(k));
    const std::vector<Vec3> before = nodes.positions;
    pull_now();
    live.follow(nodes);
    result.free_per_iteration.push_back(count_free(nodes) + frozen.count());
    if (!run.dumps.empty()) dump_nodes(run, dump_name(k), nodes, live.tets());
    const std::vector<Tet> tets = live.tets_at(relocated(nodes));
    const double now = options.iterations == 0 ? mean_quality(nodes, tets, run) : 0;
    const bool filled = options.insert_at_circumcentres && k == kFillAt &&
                        insert_at_circumcentres(nodes, tets, inside, options.edge_length) > 0;
    relocate(nodes, tets, inside, run);
    frozen.freeze(nodes, before, options.freeze * options.edge_length);
    if ((k == 1 || k == 4) && !all_free && expand(nodes, frozen, live.tets(), inside))
      active.refresh(nodes, run);
    if (options.iterations == 0 && k >= options.auto_min && now - quality < options.auto_gain)
      break;
    quality = filled ? 0 : now;  // nodes that are new spoil the mesh before they better it
  }
  frozen.thaw_boundary(nodes);
  pull_now();
  recover_edges(nodes, boundary, live,
                {.edge_length = options.edge_length, .wanted = active_edges(samples, active)});
  result.mesh = live.mesh();
  frozen.thaw_all(nodes);
  result.samples_active = active.active_count();
  return result;
}

}  // namespace remeshd
