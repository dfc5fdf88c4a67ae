#include "engine/remesh/remesh.h"

#include <algorithm>
#include <chrono>

#include "engine/base/error.h"
#include "engine/boundary/samples.h"
#include "engine/nodes/place_supports.h"
#include "engine/remesh/deliver.h"
#include "engine/remesh/master.h"
#include "engine/remesh/repair.h"
#include "engine/remesh/stages.h"

namespace remeshd {

namespace {

constexpr double kOnEntity = 1e-7;  // of the diagonal: a copied node stands on a face this near
constexpr int kRepairRounds = 8;

/// Adds up the seconds between calls, each to a phase.
class Stopwatch {
 public:
  /// The time since the last call goes to `phase`.
  void lap(double& phase) {
    const auto now = Clock::now();
    phase += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }
  [[nodiscard]] double total() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

/// What is tried, in this order, until the mesh passes verification.
enum class Attempt { AsPlanned, AllFree, OtherSeed };

double mean_free_share(const OptimiseResult& loop, std::int32_t nodes) {
  if (loop.free_per_iteration.empty() || nodes == 0) return 0;
  double sum = 0;
  for (const std::uint32_t f : loop.free_per_iteration) sum += f;
  return std::fmin(1.0, sum / static_cast<double>(loop.free_per_iteration.size()) / nodes);
}

/// The same geometry as the original's: its mesh, every node and tet kept.
void repeat(const Revision& original, const PointSource& source, Revision& revision) {
  revision.delivery = original.delivery;
  NodeMap& map = revision.delivery.map;
  const std::size_t nodes = revision.delivery.mesh.nodes.size();
  const std::size_t tets = revision.delivery.mesh.tets.size();
  map.node_origin.assign(nodes, NodeOrigin::Kept);
  map.node_transform.assign(nodes, 0);
  map.original_node.resize(nodes);
  map.original_tet.resize(tets);
  for (std::size_t n = 0; n < nodes; ++n) map.original_node[n] = static_cast<std::int32_t>(n);
  for (std::size_t t = 0; t < tets; ++t) map.original_tet[t] = static_cast<std::int32_t>(t);
  map.transforms = source.transforms();
  map.transform_features = {original.model.features[source.sources().front().original].id};
  revision.master = original.master;
  revision.meshed_source = original.meshed_source;
  revision.meshed_model = original.meshed_model;
  revision.report.quality_before = original.report.quality_before;
  revision.report.groups = original.report.groups;
  revision.report.free_share = 0;
  account(revision);
}

std::string first_failure(const Verification& v) {
  return v.failures.empty() ? "the mesh did not pass verification" : v.failures.front().what;
}

}  // namespace

Revision make_revision(const Revision* original, const ModelSource& document,
                       const MeshOptions& options, const Run& run) {
  Stopwatch watch;
  Revision revision;
  Report& report = revision.report;
  PhaseSeconds& seconds = report.seconds;
  revision.source = document;
  revision.model = evaluate(document);
  revision.meshed_source = document;
  revision.meshed_model = revision.model;
  revision.options = options;
  run.report("cells", 0);
  revision.cells = build_cells(revision.model, run);
  const CellularModel& cells = revision.cells;
  const Density density = resolve_density(original, options, cells.volume, cells.area);
  revision.edge_length = report.edge_length = density.edge_length;
  watch.lap(seconds.setup);

  run.report("difference", 0.06);
  const PointSource source(original ? &original->meshed_model : nullptr, revision.model,
                           density.edge_length, run);
  watch.lap(seconds.difference);
  if (original && source.changed().empty() && !options.nodes && !options.size) {
    repeat(*original, source, revision);
    watch.lap(seconds.copy);
    seconds.total = watch.total();
    return revision;
  }

  Candidate candidate;
  bool valid = false;
  for (const Attempt attempt : {Attempt::AsPlanned, Attempt::AllFree, Attempt::OtherSeed}) {
    if (!original && attempt == Attempt::AllFree) continue;
    const std::uint64_t seed = options.seed + (attempt == Attempt::OtherSeed ? 0x5EED : 0);
    const Revision* base = attempt == Attempt::OtherSeed ? nullptr : original;
    run.report("nodes", 0.1);
    const PointSource fresh =
        base ? source : PointSource(nullptr, revision.model, density.edge_length, run);
    const Density target =
        base == original
            ? density
            : resolve_density(nullptr, {.size = density.edge_length}, cells.volume, cells.area);
    NodeSet nodes = initial_nodes(base, fresh, target, seed, run);
    if (attempt != Attempt::AsPlanned) std::fill(nodes.free.begin(), nodes.free.end(), 1);
    watch.lap(seconds.copy);
    const Samples samples =
        sample_boundary(cells.boundary, fresh.modified(), density.edge_length, seed, {}, run);
    if (base)
      place_supports(nodes, cells.boundary, samples, density.edge_length,
                     kOnEntity * cells.boundary.bounds.diagonal());
    report.counts.samples = static_cast<std::uint32_t>(samples.points.size());
    const auto fresh_nodes = std::count(nodes.original.begin(), nodes.original.end(), -1);
    report.counts.nodes_new = static_cast<std::uint32_t>(fresh_nodes);
    report.counts.nodes_copied = static_cast<std::uint32_t>(nodes.size() - fresh_nodes);
    report.counts.free_at_start =
        static_cast<std::uint32_t>(std::count(nodes.free.begin(), nodes.free.end(), 1));
    watch.lap(seconds.setup);

    OptimiseResult loop =
        optimise(nodes, start_mesh(base, nodes, fresh, cells.boundary.bounds, run), cells.boundary,
                 fresh.modified(), samples,
                 {.edge_length = density.edge_length, .iterations = options.iterations}, run);
    watch.lap(seconds.optimise);
    report.counts.free_at_end =
        static_cast<std::uint32_t>(std::count(nodes.free.begin(), nodes.free.end(), 1));
    report.free_share = mean_free_share(loop, nodes.size());
    candidate = extract(std::move(nodes), std::move(loop), base, fresh, cells, options, run);
    int repaired = 0;
    for (int round = 0; round < kRepairRounds && !candidate.verification.valid; ++round) {
      const int inserted = insert_where_missing(candidate.nodes, candidate.verification, samples,
                                                density.edge_length);
      if (inserted == 0) break;
      repaired += inserted;
      candidate.loop.mesh =
          triangulate_anew(candidate.nodes, cells.boundary, density.edge_length, run);
      candidate = extract(std::move(candidate.nodes), std::move(candidate.loop), base, fresh, cells,
                          options, run);
    }
    if (repaired > 0)
      report.warnings.push_back(std::to_string(repaired) +
                                " nodes were inserted to make the boundary complete");
    valid = candidate.verification.valid;
    if (valid) {
      report.counts.free_per_iteration = candidate.loop.free_per_iteration;
      report.counts.iterations =
          static_cast<std::uint32_t>(candidate.loop.free_per_iteration.size());
      report.counts.active_samples = candidate.loop.samples_active;
      deliver(std::move(candidate), base, fresh, revision, run);
      watch.lap(seconds.extract);
      break;
    }
    watch.lap(seconds.extract);
    report.warnings.push_back(first_failure(candidate.verification) +
                              (attempt == Attempt::AsPlanned ? "; all nodes were optimised anew"
                                                             : "; meshed from another seed"));
  }
  if (!valid) throw error::boundary_not_recovered(first_failure(candidate.verification));
  seconds.total = watch.total();
  return revision;
}

}  // namespace remeshd
