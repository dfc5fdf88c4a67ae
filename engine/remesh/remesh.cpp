#include "engine/remesh/remesh.h"

#include <algorithm>
#include <chrono>
#include <cmath>

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
constexpr std::uint64_t kOtherSeed = 0x5EED;

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

double mean_free_share(const OptimiseResult& loop, std::int32_t nodes) {
  if (loop.free_per_iteration.empty() || nodes == 0) return 0;
  double sum = 0;
  for (const std::uint32_t f : loop.free_per_iteration) sum += f;
  return std::fmin(1.0, sum / static_cast<double>(loop.free_per_iteration.size()) / nodes);
}

/// The same geometry as the original's: its mesh, every node and tet kept.
void repeat(const Revision& original, const PointSource& source, Revision& revision,
            const Run& run) {
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
  revision.report.way = Way::Unchanged;
  revision.report.free_share = 0;
  account(revision, run);
}

std::string first_failure(const Verification& v) {
  return v.failures.empty() ? "the mesh did not pass verification" : v.failures.front().what;
}

/// What one try at a mesh works with. `original` is null where everything is new.
struct Setting {
  const Revision* original;
  const PointSource& source;
  const CellularModel& cells;
  const Density& density;
  const MeshOptions& options;
  std::uint64_t seed;
  bool all_free;  ///< optimise the copied nodes too, all of them
};

std::uint32_t count(const std::vector<std::uint8_t>& flags, std::uint8_t value) {
  return static_cast<std::uint32_t>(std::count(flags.begin(), flags.end(), value));
}

/// Nodes, optimisation, extraction, verification (Sects. 6-8), and repair where the boundary is not
/// all there. What was done goes into the report, whether or not the mesh is valid.
Candidate try_mesh(const Setting& s, Report& report, Stopwatch& watch, const Run& run) {
  const BoundaryModel& boundary = s.cells.boundary;
  const Membership& membership = s.source.modified();
  const double l = s.density.edge_length;
  Counts& counts = report.counts;

  run.report("nodes", 0.1);
  NodeSet nodes = initial_nodes(s.original, s.source, s.density, s.options.start, s.seed, run);
  if (s.all_free) std::fill(nodes.free.begin(), nodes.free.end(), 1);
  counts.nodes_new =
      static_cast<std::uint32_t>(std::count(nodes.original.begin(), nodes.original.end(), -1));
  counts.nodes_copied = static_cast<std::uint32_t>(nodes.size()) - counts.nodes_new;
  watch.lap(report.seconds.copy);

  const Samples samples = sample_boundary(boundary, membership, l, s.seed, {}, run);
  const InsideTest inside = inside_test(s.options.inside, membership, boundary, run);
  counts.samples = static_cast<std::uint32_t>(samples.points.size());
  if (s.original)
    place_supports(nodes, boundary, samples, l, kOnEntity * boundary.bounds.diagonal(), run);
  counts.free_at_start = count(nodes.free, 1);
  const bool all_free = count(nodes.free, 0) == 0;
  watch.lap(report.seconds.setup);

  OptimiseResult loop =
      optimise(nodes, start_mesh(s.original, nodes, s.source, boundary.bounds, run), boundary,
               inside, samples, {.edge_length = l, .iterations = s.options.iterations}, run);
  counts.free_at_end = count(nodes.free, 1);
  counts.free_per_iteration = loop.free_per_iteration;
  counts.iterations = static_cast<std::uint32_t>(loop.free_per_iteration.size());
  counts.active_samples = loop.samples_active;
  // Nodes added on the way are free from their first iteration on.
  report.free_share = all_free ? 1 : mean_free_share(loop, nodes.size());
  watch.lap(report.seconds.optimise);

  Candidate candidate = extract(std::move(nodes), std::move(loop), s.original, s.source, s.cells,
                                inside, s.options, run);
  int repaired = 0;
  for (int round = 0; round < kRepairRounds && !candidate.verification.valid; ++round) {
    const int inserted =
        insert_where_missing(candidate.nodes, candidate.verification, boundary, samples, l);
    if (inserted == 0) break;
    repaired += inserted;
    candidate.loop.mesh = triangulate_anew(candidate.nodes, boundary, l, run);
    candidate = extract(std::move(candidate.nodes), std::move(candidate.loop), s.original, s.source,
                        s.cells, inside, s.options, run);
  }
  counts.nodes_inserted = static_cast<std::uint32_t>(repaired);
  if (repaired > 0)
    report.warnings.push_back(std::to_string(repaired) +
                              " nodes were inserted to make the boundary complete");
  watch.lap(report.seconds.extract);
  return candidate;
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
    repeat(*original, source, revision, run);
    watch.lap(seconds.copy);
    seconds.total = watch.total();
    return revision;
  }

  // As planned; failing that with every copied node free; failing that from new nodes altogether.
  Setting setting{original, source, cells, density, options, options.seed, false};
  Candidate candidate = try_mesh(setting, report, watch, run);
  if (original && !candidate.verification.valid) {
    report.warnings.push_back(first_failure(candidate.verification) +
                              "; all nodes were optimised anew");
    setting.all_free = true;
    report.way = Way::Full;
    candidate = try_mesh(setting, report, watch, run);
  }
  if (candidate.verification.valid) {
    deliver(std::move(candidate), original, original, source, revision, run);
  } else {
    report.warnings.push_back(first_failure(candidate.verification) + "; meshed from another seed");
    report.way = Way::Fresh;
    const PointSource nothing(nullptr, revision.model, density.edge_length, run);
    Density same = density;
    if (!options.size) same.count = std::lround(density.nodes_per_volume * cells.volume);
    candidate = try_mesh({nullptr, nothing, cells, same, options, options.seed + kOtherSeed, true},
                         report, watch, run);
    if (!candidate.verification.valid)
      throw error::boundary_not_recovered(first_failure(candidate.verification));
    deliver(std::move(candidate), nullptr, original, nothing, revision, run);
  }
  watch.lap(seconds.extract);
  seconds.total = watch.total();
  return revision;
}

}  // namespace remeshd
