#include "engine/remesh/ways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "engine/boundary/samples.h"
#include "engine/nodes/density.h"
#include "engine/nodes/place_supports.h"
#include "engine/optimise/live_mesh.h"
#include "engine/remesh/failure_place.h"
#include "engine/remesh/last_resort.h"
#include "engine/remesh/repair.h"

namespace remeshd {
namespace {

constexpr double kOnEntity = 1e-7;  // of the diagonal: a copied node stands on a face this near
constexpr int kRepairRounds = 8;
// x edge length. Of 136 attempts of the campaign 9 had to go on from 4 to the next and 22 from 3.5;
// from 5 it is 3, but parts of the cases are a tenth to a half larger.
struct PartReach {
  double lengths;
  const char* strategy;
};
constexpr std::array kReaches{PartReach{4, "local, 4 edge lengths"},
                              PartReach{6, "local, 6 edge lengths"},
                              PartReach{8, "local, 8 edge lengths"}};
constexpr double kFewInserted = 200, kMostInserted = 0.2;
constexpr std::uint64_t kOtherSeed = 0x5EED;

/// More nodes beside those there are than this no boundary of the edge length asked for needs.
double few_more(double nodes) { return kFewInserted + kMostInserted * nodes; }

bool is_finer_than_asked(const Revision& r) {
  const double regular = expected_nodes(r.cells.volume, r.cells.area, r.edge_length);
  return static_cast<double>(r.delivery.mesh.nodes.size()) > regular + few_more(regular);
}

double mean_free_share(const OptimiseResult& loop, std::int32_t nodes) {
  if (loop.free_per_iteration.empty() || nodes == 0) return 0;
  double sum = 0;
  for (const std::uint32_t f : loop.free_per_iteration) sum += f;
  return std::fmin(1.0, sum / static_cast<double>(loop.free_per_iteration.size()) / nodes);
}

std::uint32_t count(const std::vector<std::uint8_t>& flags, std::uint8_t value) {
  return static_cast<std::uint32_t>(std::count(flags.begin(), flags.end(), value));
}

}  // namespace

Ways::Ways(const Revision* original, Revision& revision, const Density& density, Stopwatch& watch,
           const Run& run)
    : original_(original), revision_(revision), density_(density), watch_(watch), run_(run) {}

/// Not one initialiser list: g++ 12 destroys a member that it has not made yet where a later one
/// throws, as `points_of` does when the run is stopped.
NewMesh Ways::begin(const Revision* copied_from) {
  NewMesh made;
  made.copied_from = copied_from;
  made.source = points_of(copied_from);
  return made;
}

NewMesh Ways::first_valid() {
  NewMesh made = begin(original_);
  watch_.lap(revision_.report.seconds.difference);
  Candidate& candidate = made.candidate;
  Setting setting{original_ ? "local, everywhere" : "local",
                  {original_, *made.source, revision_.cells, revision_.options},
                  density_,
                  revision_.options.seed,
                  false};
  candidate = attempt(setting);
  const auto failed = [&] { return !candidate.verification.valid; };
  // New places for all nodes would lose the boundary again that the original has by its many.
  if (failed() && original_ && !candidate.too_fine && !is_finer_than_asked(*original_)) {
    next(Way::Full, made, "all nodes were optimised anew");
    setting.strategy = "full";
    setting.all_free = true;
    candidate = attempt(setting);
  }
  if (failed() && !candidate.too_fine) {
    next(Way::Fresh, made, "meshed from another seed");
    made = regular(revision_.options.seed + kOtherSeed, "fresh");
  }
  if (failed()) {
    next(Way::TetGen, made, "meshed by TetGen");
    made.copied_from = nullptr;
    made.source = points_of(nullptr);
    candidate =
        last_resort({revision_.model, made.source->modified(), revision_.cells,
                     density_.edge_length, revision_.options.clean_up, revision_.options.threshold},
                    candidate.verification, run_);
    Report& report = revision_.report;
    report.attempts.insert(report.attempts.end(), candidate.given_up.begin(),
                           candidate.given_up.end());
    report.seconds.verify += candidate.verify_seconds;
    report.counts = {.nodes_new = static_cast<std::uint32_t>(candidate.whole.mesh.nodes.size())};
  }
  return made;
}

NewMesh Ways::regular(std::uint64_t seed, const char* strategy) {
  NewMesh made = begin(nullptr);
  Density same = density_;
  const MeshOptions& options = revision_.options;
  if (!options.size) same.count = std::lround(same.nodes_per_volume * revision_.cells.volume);
  made.candidate =
      attempt({strategy, {nullptr, *made.source, revision_.cells, options}, same, seed, true});
  return made;
}

Attempt Ways::last_given_up(std::string reason) const {
  return trial_->given_up(std::move(reason));
}

std::string Ways::fault_of(const NewMesh& made) const {
  return describe_failure(made.candidate, *made.source).message;
}

std::shared_ptr<const PointSource> Ways::points_of(const Revision* original) {
  return std::make_shared<const PointSource>(original ? &original->master_model() : nullptr,
                                             revision_.model, density_.edge_length, run_);
}

/// What is wrong with a mesh, and where.
Warning Ways::describe_failure(const Candidate& failed, const PointSource& source) const {
  Warning warning{.code = WarningCode::Fallback};
  const auto& failures = failed.verification.failures;
  if (failures.empty()) {
    warning.message = "the mesh did not pass verification";
    return warning;
  }
  const MeshDefect& defect = failures.front();
  FailurePlace place = find_failure(defect, revision_.model, source.modified(),
                                    revision_.cells.boundary, density_.edge_length);
  warning.message = describe(defect, place);
  if (!place.faces.empty()) warning.point = defect.place;
  warning.features = std::move(place.features);
  return warning;
}

/// Tells that a mesh has failed, where, and what is done about it.
void Ways::next(Way way, const NewMesh& failed, const char* what) {
  Report& report = revision_.report;
  report.way = way;
  Warning warning = describe_failure(failed.candidate, *failed.source);
  report.attempts.push_back(last_given_up(
      warning.message + (failed.candidate.too_fine
                             ? "; its boundary takes far more nodes than were asked for"
                             : "")));
  warning.message += std::string("; ") + what;
  report.warnings.push_back(std::move(warning));
  run_.warn({&report.warnings.back(), 1});
}

/// Within the part of the original that what changes reaches; where that does not do, gives no
/// valid mesh or leaves bad tets at its rim, within a larger one, and at last within all of it.
Candidate Ways::attempt(const Setting& s) {
  const Target& target = s.target;
  const bool local = target.original && !s.all_free &&
                     target.options.clean_up == target.original->options.clean_up &&
                     target.source.identity() >= 0;
  std::optional<EntityMap> map;
  if (local) {
    const BoundaryModel& boundary = target.cells.boundary;
    map.emplace(target.original->cells.boundary, boundary, kOnEntity * boundary.bounds.diagonal());
    Report& report = revision_.report;
    const std::size_t before = report.warnings.size();
    for (const auto& [lengths, strategy] : kReaches) {
      trial_.emplace(strategy);
      auto made = attempt_in_part(s, {lengths * s.density.edge_length, &*map},
                                  lengths == kReaches.back().lengths);
      if (auto* candidate = std::get_if<Candidate>(&made)) return std::move(*candidate);
      report.attempts.push_back(last_given_up(std::get<std::string>(made)));
      report.warnings.resize(before);
    }
  }
  trial_.emplace(s.strategy);
  return *attempt_within(s, {HUGE_VAL, nullptr});
}

/// Within a part of the original: a valid mesh or one that no larger part would make valid, else
/// why not. `largest`: no larger one is tried, bad tets at the rim or not.
std::variant<Candidate, std::string> Ways::attempt_in_part(const Setting& s, const Reach& reach,
                                                           bool largest) {
  try {
    std::optional<Candidate> made = attempt_within(s, reach);
    if (!made) return "a node of the base stands on nothing that the boundary still has";
    if (!made->verification.valid && !made->too_fine)
      return describe_failure(*made, s.target.source).message;
    if (made->bad_at_rim > 0 && !largest)
      return std::to_string(made->bad_at_rim) +
             " tets beside what stays of the base could not be cleaned up";
    return *std::move(made);
  } catch (const LeftPart& left) {
    return std::string("the part cut out of the base did not suffice for ") + left.where;
  }
}

/// Nodes, optimisation, extraction, verification (Sects. 6-8), and repair where the boundary is not
/// all there. What was done goes into the report, whether or not the mesh is valid.
std::optional<Candidate> Ways::attempt_within(const Setting& s, const Reach& reach) {
  const auto& [original, source, cells, options] = s.target;
  const BoundaryModel& boundary = cells.boundary;
  const Membership& membership = source.modified();
  const double l = s.density.edge_length;
  Report& report = revision_.report;
  Counts& counts = report.counts;

  run_.report("nodes", 0.1);
  std::optional<LocalNodes> local =
      initial_nodes(original, source, s.density, options.start, s.seed, reach, run_);
  if (!local) return std::nullopt;
  NodeSet& nodes = local->nodes;
  if (s.all_free) std::fill(nodes.free.begin(), nodes.free.end(), 1);
  counts.nodes_new =
      static_cast<std::uint32_t>(std::count(nodes.original.begin(), nodes.original.end(), -1));
  counts.nodes_copied =
      static_cast<std::uint32_t>(nodes.size() + nodes.elsewhere) - counts.nodes_new;
  watch_.lap(report.seconds.copy);

  SampleOptions sampling;
  if (std::isfinite(reach.length)) sampling.where = sampled_places(*local, l, reach);
  const Samples samples = sample_boundary(boundary, membership, l, s.seed, sampling, run_);
  const InsideTest inside = inside_test(options.inside, membership, boundary, run_);
  counts.samples = static_cast<std::uint32_t>(samples.points.size());
  if (original)
    place_supports(nodes, boundary, samples, l, kOnEntity * boundary.bounds.diagonal(),
                   local->placed, run_);
  counts.free_at_start = count(nodes.free, 1);
  const bool all_free = nodes.elsewhere == 0 && count(nodes.free, 0) == 0;
  watch_.lap(report.seconds.setup);

  StartMesh start = start_mesh(*local, source, boundary.bounds, run_);
  OptimiseResult loop = optimise(nodes, std::move(start), boundary, inside, samples,
                                 {.edge_length = l,
                                  .iterations = options.iterations,
                                  .fill_voids = original && !s.all_free && s.density.inherited,
                                  .rebuild = options.rebuild},
                                 run_);
  counts.free_at_end = count(nodes.free, 1);
  counts.free_per_iteration = loop.free_per_iteration;
  counts.iterations = static_cast<std::uint32_t>(loop.free_per_iteration.size());
  counts.active_samples = loop.samples_active;
  // Nodes added on the way are free from their first iteration on.
  report.free_share = all_free ? 1 : mean_free_share(loop, nodes.size() + nodes.elsewhere);
  watch_.lap(report.seconds.optimise);

  const Site site{local->part, reach.map};
  Candidate candidate =
      extract(std::move(nodes), std::move(loop), local->part, source, cells, inside, run_);
  counts.nodes_inserted = finish_repaired(candidate, s, site, samples, inside);
  if (counts.nodes_inserted > 0)
    report.warnings.push_back({.code = WarningCode::NodesInserted,
                               .message = std::to_string(counts.nodes_inserted) +
                                          " nodes were inserted to make the boundary complete"});
  watch_.lap(report.seconds.extract);
  report.seconds.verify += candidate.verify_seconds;
  return candidate;
}

/// Finishes a mesh, with nodes inserted where the boundary is not all there: as long as the peeled
/// mesh shows that by itself, and then where verification finds it. Returns their number.
std::uint32_t Ways::finish_repaired(Candidate& c, const Setting& s, const Site& site,
                                    const Samples& samples, const InsideTest& inside) {
  const CellularModel& cells = s.target.cells;
  const double l = s.density.edge_length;
  const bool clean_up = s.target.options.clean_up;
  const auto most =
      static_cast<std::uint32_t>(few_more(static_cast<double>(c.nodes.size() + c.nodes.elsewhere)));
  std::uint32_t repaired = 0;
  const auto insert_at = [&](std::span<const MeshDefect> defects) {
    const std::int32_t first = c.nodes.size();
    if (c.too_fine || insert_where_missing(c.nodes, defects, cells.boundary, samples, l) == 0)
      return false;
    c.loop.mesh = with_nodes_inserted(c.loop.mesh, first, c.nodes, cells.boundary, l, run_);
    repaired += c.nodes.size() - first;
    const double verified = c.verify_seconds;
    c = extract(std::move(c.nodes), std::move(c.loop), site.part, s.target.source, cells, inside,
                run_);
    c.verify_seconds = verified;
    c.too_fine = repaired > most;
    return true;
  };
  int rounds_at_stray = 0;
  const auto insert_at_stray_facets = [&] {
    for (; rounds_at_stray < kRepairRounds && !c.delaunay.stray.empty(); ++rounds_at_stray)
      if (!insert_at(stray_facets(c.delaunay))) break;
  };
  insert_at_stray_facets();
  finish(c, s.target, site, clean_up, run_);
  for (int round = 0; round < kRepairRounds && !c.verification.valid; ++round) {
    if (!insert_at(c.verification.failures)) break;
    insert_at_stray_facets();
    // What the peeled mesh lacks no clean-up brings back.
    finish(c, s.target, site, false, run_);
    if (clean_up && boundary_is_complete(c.verification)) finish(c, s.target, site, true, run_);
  }
  return repaired;
}

}  // namespace remeshd
