#include "engine/remesh/remesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

#include "engine/boundary/samples.h"
#include "engine/nodes/density.h"
#include "engine/nodes/place_supports.h"
#include "engine/remesh/continuation.h"
#include "engine/remesh/deliver.h"
#include "engine/remesh/last_resort.h"
#include "engine/remesh/master.h"
#include "engine/remesh/repair.h"
#include "engine/remesh/stages.h"
#include "engine/remesh/stopwatch.h"

namespace remeshd {

namespace {

constexpr double kOnEntity = 1e-7;  // of the diagonal: a copied node stands on a face this near
constexpr int kRepairRounds = 8;
/// More nodes than this, a number and a share of those there are, no boundary of the edge length
/// asked for needs.
constexpr std::uint32_t kFewInserted = 200;
constexpr double kMostInserted = 0.2;
constexpr double kWornQuality = 0.005, kWornDensity = 0.1;
constexpr std::uint64_t kOtherSeed = 0x5EED;

double mean_free_share(const OptimiseResult& loop, std::int32_t nodes) {
  if (loop.free_per_iteration.empty() || nodes == 0) return 0;
  double sum = 0;
  for (const std::uint32_t f : loop.free_per_iteration) sum += f;
  return std::fmin(1.0, sum / static_cast<double>(loop.free_per_iteration.size()) / nodes);
}

/// The same geometry as the original's: its mesh, every node and tet kept.
void repeat(const Revision& original, Revision& revision, const Run& run) {
  deliver_kept(original, original.delivery.mesh.nodes, revision);
  revision.anchor = original.anchor;
  revision.reference = original.reference;
  revision.meshed_source = original.meshed_source;
  revision.meshed_model = original.meshed_model;
  revision.report.groups = original.report.groups;
  revision.report.verification = original.report.verification;
  revision.report.verification.tets_inherited +=
      std::exchange(revision.report.verification.tets_proved, 0);
  revision.report.way = Way::Unchanged;
  account(revision, run);
}

/// Nearly the same geometry: the connectivity of the original's mesh, where that serves.
bool continue_with(const Revision& original, Revision& revision, const Run& run) {
  auto result = continue_mesh(original, revision, run);
  if (const auto* why = std::get_if<NotContinued>(&result)) {
    if (!why->empty())
      revision.report.warnings.push_back("the connectivity could not be kept: " + *why);
    return false;
  }
  auto& mesh = std::get<ContinuedMesh>(result);
  revision.report.seconds.verify += mesh.verify_seconds;
  revision.report.verification = figures_of(mesh.verification);
  deliver_kept(original, std::move(mesh.mesh.nodes), revision);
  const Membership membership(revision.model);
  name_delivery(mesh.verification.surface, mesh.supports, membership, revision, run);
  const FeatureModel& made_for = original.master_model();
  revision.anchor = std::make_shared<const Anchor>(
      Anchor{original.anchor ? original.anchor->source : original.meshed_source,
             made_for,
             {original.master_nodes().begin(), original.master_nodes().end()},
             std::move(mesh.supports)});
  revision.reference = original.reference;
  revision.report.way = Way::Continued;
  revision.report.free_share =
      mesh.nodes_moved / static_cast<double>(revision.delivery.mesh.nodes.size());
  account(revision, run);
  return true;
}

/// Whether an edit with these options may answer with the tets of its base.
bool keeps_connectivity(const Revision& original, const MeshOptions& options) {
  return !options.nodes && !options.size && options.clean_up == original.options.clean_up &&
         options.threshold == original.options.threshold;
}

std::string first_failure(const Verification& v) {
  return v.failures.empty() ? "the mesh did not pass verification" : v.failures.front().what;
}

/// What one try at a mesh works with.
struct Setting {
  Target target;
  const Density& density;
  std::uint64_t seed;
  bool all_free;  ///< optimise the copied nodes too, all of them
};

std::uint32_t count(const std::vector<std::uint8_t>& flags, std::uint8_t value) {
  return static_cast<std::uint32_t>(std::count(flags.begin(), flags.end(), value));
}

/// Inserts nodes where the boundary is not all there. Returns their number.
std::uint32_t repair(Candidate& c, const Setting& s, const Samples& samples,
                     const InsideTest& inside, const Run& run) {
  const CellularModel& cells = s.target.cells;
  const double l = s.density.edge_length;
  const auto most = kFewInserted + static_cast<std::uint32_t>(kMostInserted * c.nodes.size());
  std::uint32_t repaired = 0;
  for (int round = 0; round < kRepairRounds && !c.verification.valid; ++round) {
    const std::int32_t first = c.nodes.size();
    if (insert_where_missing(c.nodes, c.verification, cells.boundary, samples, l) == 0) break;
    c.loop.mesh = with_nodes_inserted(c.loop.mesh, first, c.nodes, cells.boundary, l, run);
    repaired += c.nodes.size() - first;
    c.too_fine = repaired > most;
    if (c.too_fine) break;
    c = extract(std::move(c.nodes), std::move(c.loop), cells, inside, run);
    // What the peeled mesh lacks no clean-up brings back.
    c.verification = verify({c.nodes.positions, c.delaunay}, c.nodes.supports, cells.boundary,
                            cells.volume, run);
    if (boundary_is_complete(c.verification)) finish(c, s.target, run);
  }
  return repaired;
}

/// Nodes, optimisation, extraction, verification (Sects. 6-8), and repair where the boundary is not
/// all there. What was done goes into the report, whether or not the mesh is valid.
Candidate try_mesh(const Setting& s, Report& report, Stopwatch& watch, const Run& run) {
  const auto& [original, source, cells, options] = s.target;
  const BoundaryModel& boundary = cells.boundary;
  const Membership& membership = source.modified();
  const double l = s.density.edge_length;
  Counts& counts = report.counts;

  run.report("nodes", 0.1);
  NodeSet nodes = initial_nodes(original, source, s.density, options.start, s.seed, run);
  if (s.all_free) std::fill(nodes.free.begin(), nodes.free.end(), 1);
  counts.nodes_new =
      static_cast<std::uint32_t>(std::count(nodes.original.begin(), nodes.original.end(), -1));
  counts.nodes_copied = static_cast<std::uint32_t>(nodes.size()) - counts.nodes_new;
  watch.lap(report.seconds.copy);

  const Samples samples = sample_boundary(boundary, membership, l, s.seed, {}, run);
  const InsideTest inside = inside_test(options.inside, membership, boundary, run);
  counts.samples = static_cast<std::uint32_t>(samples.points.size());
  if (original)
    place_supports(nodes, boundary, samples, l, kOnEntity * boundary.bounds.diagonal(), run);
  counts.free_at_start = count(nodes.free, 1);
  const bool all_free = count(nodes.free, 0) == 0;
  watch.lap(report.seconds.setup);

  OptimiseResult loop =
      optimise(nodes, start_mesh(original, nodes, source, boundary.bounds, run), boundary, inside,
               samples, {.edge_length = l, .iterations = options.iterations}, run);
  counts.free_at_end = count(nodes.free, 1);
  counts.free_per_iteration = loop.free_per_iteration;
  counts.iterations = static_cast<std::uint32_t>(loop.free_per_iteration.size());
  counts.active_samples = loop.samples_active;
  // Nodes added on the way are free from their first iteration on.
  report.free_share = all_free ? 1 : mean_free_share(loop, nodes.size());
  watch.lap(report.seconds.optimise);

  Candidate candidate = extract(std::move(nodes), std::move(loop), cells, inside, run);
  finish(candidate, s.target, run);
  counts.nodes_inserted = repair(candidate, s, samples, inside, run);
  if (counts.nodes_inserted > 0)
    report.warnings.push_back(std::to_string(counts.nodes_inserted) +
                              " nodes were inserted to make the boundary complete");
  watch.lap(report.seconds.extract);
  report.seconds.verify += candidate.verify_seconds;
  return candidate;
}

WearReference reference_of(const Revision& r) {
  return {r.report.quality.volume_length_mean,
          static_cast<double>(r.report.counts.nodes) /
              expected_nodes(r.cells.volume, r.cells.area, r.edge_length)};
}

/// Whether it is the chain's last regular mesh itself: one edit wears nothing out.
bool is_regular(const Revision& r) {
  return r.reference.volume_length_mean == r.report.quality.volume_length_mean;
}

/// Whether so much is lost against the last regular mesh that another may be worth its time.
bool worn(const WearReference& now, const WearReference& then) {
  return now.volume_length_mean < then.volume_length_mean - kWornQuality ||
         std::fabs(now.nodes_over_expected / then.nodes_over_expected - 1) > kWornDensity;
}

/// `0.801 mean volume-length, 1.08 of the nodes expected`.
std::string text(const WearReference& r) {
  std::array<char, 96> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.3f mean volume-length, %.2f of the nodes expected",
                r.volume_length_mean, r.nodes_over_expected);
  return buffer.data();
}

/// Tells that a mesh has failed and what is done about it.
void next_way(Report& report, Way way, const Verification& failed, const char* what) {
  report.way = way;
  report.warnings.push_back(first_failure(failed) + "; " + what);
}

}  // namespace

const FeatureModel& Revision::master_model() const { return anchor ? anchor->model : meshed_model; }

std::span<const Vec3> Revision::master_nodes() const {
  return anchor ? anchor->nodes : delivery.mesh.nodes;
}

std::span<const Support> Revision::supports() const {
  const std::vector<Support>& all = anchor ? anchor->supports : master->supports;
  return std::span(all).first(delivery.mesh.nodes.size());
}

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
  if (original && keeps_connectivity(*original, options)) {
    const bool same = same_geometry(original->meshed_model, revision.model);
    if (same) repeat(*original, revision, run);
    if (same || continue_with(*original, revision, run)) {
      watch.lap(seconds.copy);
      seconds.total = watch.total();
      return revision;
    }
  }
  const PointSource source(original ? &original->master_model() : nullptr, revision.model,
                           density.edge_length, run);
  watch.lap(seconds.difference);

  // As planned; failing that with every copied node free; failing that from new nodes altogether.
  Setting setting{{original, source, cells, options}, density, options.seed, false};
  Candidate candidate = try_mesh(setting, report, watch, run);
  const Revision* copied_from = original;
  const auto failed = [&] { return !candidate.verification.valid; };
  // Where the boundary has details far finer than the edge length, placing nodes anew is in vain.
  if (failed() && original && !candidate.too_fine) {
    next_way(report, Way::Full, candidate.verification, "all nodes were optimised anew");
    setting.all_free = true;
    candidate = try_mesh(setting, report, watch, run);
  }
  const PointSource* copied_by = &source;
  std::optional<PointSource> nothing;
  const auto mesh_anew = [&](std::uint64_t seed) {
    copied_from = nullptr;
    copied_by = &nothing.emplace(nullptr, revision.model, density.edge_length, run);
    Density same = density;
    if (!options.size) same.count = std::lround(density.nodes_per_volume * cells.volume);
    return try_mesh({{nullptr, *copied_by, cells, options}, same, seed, true}, report, watch, run);
  };
  if (failed() && !candidate.too_fine) {
    next_way(report, Way::Fresh, candidate.verification, "meshed from another seed");
    candidate = mesh_anew(options.seed + kOtherSeed);
  }
  if (failed()) {
    next_way(report, Way::TetGen, candidate.verification, "meshed by TetGen");
    copied_from = nullptr;
    copied_by = &nothing.emplace(nullptr, revision.model, density.edge_length, run);
    candidate = last_resort({revision.model, copied_by->modified(), cells, density.edge_length,
                             options.clean_up, options.threshold},
                            candidate.verification, run);
    report.counts = {.nodes_new = static_cast<std::uint32_t>(candidate.nodes.size())};
  }
  deliver(std::move(candidate), copied_from, original, *copied_by, revision, run);

  const WearReference now = reference_of(revision);
  const bool by_rule = original && !options.nodes && !options.size;
  revision.reference = by_rule && report.way != Way::Fresh ? original->reference : now;
  if (by_rule && copied_from && !is_regular(*original) && worn(now, original->reference)) {
    const Report as_remeshed = report;
    candidate = mesh_anew(options.seed);
    Revision anew = revision;
    if (!failed()) deliver(std::move(candidate), nullptr, original, *copied_by, anew, run);
    anew.reference = reference_of(anew);
    if (!failed() && worn(now, anew.reference)) {
      revision = std::move(anew);
      revision.report.way = Way::Rebased;
      revision.report.warnings.push_back("the mesh had worn (" + text(now) +
                                         ") and was made anew (" + text(revision.reference) + ")");
    } else {
      const PhaseSeconds spent = report.seconds;
      revision.report = as_remeshed;
      report.seconds = spent;
      revision.reference = now;
    }
  }
  watch.lap(seconds.extract);
  seconds.total = watch.total();
  return revision;
}

}  // namespace remeshd
