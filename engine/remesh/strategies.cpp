#include "engine/remesh/strategies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "engine/base/error.h"
#include "engine/delivery/lost_names.h"
#include "engine/nodes/density.h"
#include "engine/remesh/last_resort/tetgen_mesh.h"
#include "engine/remesh/morph/hold.h"
#include "engine/remesh/steps.h"

namespace remeshd {
namespace {

/// The greatest ratio between the edge length that a node was made for and the one wanted, for a
/// mesh that is still morphed. Nodes are made anew beyond a ratio of 1.25. A mesh may have nodes
/// just below that; a motion small enough for morphing is no reason to make them anew when it takes
/// them slightly beyond.
constexpr double kMostOffMorphed = 1.3;

/// Whether both meshes are even, or no node that is to be made anew for its edge length is off by
/// more than this ratio.
bool is_sized_alike(const Problem& problem, double most_off) {
  const bool even = problem.modified.options.sizing.even && problem.parent.options.sizing.even;
  return even || problem.most_off() <= most_off;
}

/// Whether the mesh of an edit is cleaned up as its parent's was.
bool is_cleaned_alike(const Problem& problem) {
  const MeshOptions &now = problem.modified.options, &then = problem.parent.options;
  return now.clean_up == then.clean_up && now.threshold == then.threshold;
}

/// Whether an edit with these options may answer with the tets of its parent. The plan, which is
/// made to compare edge lengths, last.
bool may_keep_tets(const Problem& problem, double most_off) {
  return problem.density.inherited && is_cleaned_alike(problem) &&
         is_sized_alike(problem, most_off);
}

bool is_same_model(const Problem& problem, const Attempt*) {
  return same_geometry(problem.parent.meshed_model, problem.modified.model) &&
         problem.changed_rims().empty() && may_keep_tets(problem, 1);
}

/// Whether its options ask to keep connectivity for longer than morphing does.
bool is_to_be_held(const Problem& problem, const Attempt*) {
  return problem.modified.options.hold > 0 && !problem.parent.model.features.empty();
}

/// Whether the sizes and the rules for them are those of the parent, as they are written: while the
/// connectivity is held, sizes that depend on parameters need not follow these.
bool asks_for_same_sizes(const Problem& problem) {
  return problem.modified.options.sizing == problem.parent.options.sizing &&
         problem.modified.source.sizes == problem.parent.source.sizes;
}

bool may_morph(const Problem& problem, const Attempt*) {
  return problem.modified.options.hold == 0 &&
         may_keep_tets(problem, asks_for_same_sizes(problem) ? kMostOffMorphed : 1);
}

bool is_first_mesh(const Problem& problem, const Attempt*) {
  return problem.parent.model.features.empty();
}

/// Whether placing nodes may help. Where details are far finer than the edge length it cannot make
/// the boundary complete; a first mesh goes on to TetGen then.
bool may_place_nodes(const Problem& problem, const Attempt* failed) {
  return failed == nullptr || !failed->too_fine || !is_first_mesh(problem, failed);
}

/// Whether what changes may be cut out of the parent's mesh.
bool has_patches(const Problem& problem, const Attempt* failed) {
  return may_place_nodes(problem, failed) && problem.plan().identity() >= 0 &&
         problem.modified.options.clean_up == problem.parent.options.clean_up;
}

/// Whether it is known where the last mesh was wrong.
bool has_places(const Problem& problem, const Attempt* failed) {
  return may_place_nodes(problem, failed) && failed != nullptr && !failed->faulty_places().empty();
}
bool has_places_in_patches(const Problem& problem, const Attempt* failed) {
  return has_patches(problem, failed) && has_places(problem, failed);
}
/// A larger patch is of no use where it is known what is wrong inside of the last one.
bool needs_larger_patch(const Problem& problem, const Attempt* failed) {
  return has_patches(problem, failed) &&
         (problem.modified.options.sizing.even || !has_places(problem, failed));
}

/// Whether all copied nodes may be freed. Where the parent has many more nodes than its edge length
/// asks for, its boundary needs them as they are, and would be lost.
bool may_free_nodes(const Problem& problem, const Attempt* failed) {
  const Revision& parent = problem.parent;
  if (!may_place_nodes(problem, failed) || !problem.copies()) return false;
  const double regular = expected_nodes(parent.cells.volume, parent.cells.area, parent.edge_length);
  return static_cast<double>(parent.output.mesh.nodes.size()) <= regular + few_more_nodes(regular);
}

bool always(const Problem&, const Attempt*) { return true; }

Attempt keep_mesh(const Strategy& how, const Problem&, const Attempt*) { return Attempt(how.name); }

/// The attempt with the moved mesh of `result`, or with the reason why there is none. `given_up`:
/// the warning for that case; the reason is added to its message.
Attempt morphed(const Strategy& how, const Problem& problem,
                std::variant<MorphedMesh, NotMorphed> result, Warning given_up) {
  Attempt attempt(how.name);
  if (auto* why = std::get_if<NotMorphed>(&result)) {
    attempt.serves = !why->empty();
    given_up.message += *why;
    attempt.warnings.push_back(std::move(given_up));
    attempt.reason = std::move(*why);
    return attempt;
  }
  auto& mesh = std::get<MorphedMesh>(result);
  attempt.seconds.verify = mesh.verify_seconds;
  attempt.free_share =
      mesh.nodes_moved / static_cast<double>(problem.parent.output.mesh.nodes.size());
  attempt.mesh = std::move(mesh);
  return attempt;
}

Attempt morph(const Strategy& how, const Problem& problem, const Attempt*) {
  return morphed(
      how, problem, morph_mesh(problem.parent, problem.modified, problem.run),
      {.code = WarningCode::Fallback, .message = "the connectivity could not be kept: "});
}

Attempt hold(const Strategy& how, const Problem& problem, const Attempt*) {
  const auto held = [&]() -> std::variant<MorphedMesh, NotMorphed> {
    if (!problem.density.inherited) return NotMorphed("another density is asked for");
    if (!asks_for_same_sizes(problem)) return NotMorphed("other sizes are asked for");
    if (!is_cleaned_alike(problem)) return NotMorphed("another clean-up is asked for");
    return hold_mesh(problem.parent, problem.modified, problem.run);
  };
  return morphed(how, problem, held(),
                 {.code = WarningCode::HoldEnded, .message = "the connectivity was not held: "});
}

/// TetGen's time for a whole model. What it has an answer for takes it a few seconds, or .1 ms a
/// node; on surfaces that come within rounding of each other it may never end.
kernel::TetGenLimits tetgen_limits(const Problem& problem) {
  const CellularModel& cells = problem.modified.cells;
  const double nodes = expected_nodes(cells.volume, cells.area, problem.density.sizes.base());
  return {.seconds = std::round(20 + 5e-4 * nodes)};
}

Attempt by_tetgen(const Strategy& how, const Problem& problem, const Attempt* failed) {
  Attempt attempt(how.name);
  const MeshOptions& options = problem.modified.options;
  const auto plan = plan_of_nothing(problem);
  Candidate made =
      tetgen_mesh({problem.modified.model, *plan, problem.modified.cells, problem.density.sizes,
                   options.clean_up, options.threshold, tetgen_limits(problem)},
                  failed->candidate()->verification, problem.run);
  attempt.tries = std::move(made.given_up);
  attempt.seconds.verify = made.verify_seconds;
  attempt.counts = {.nodes_new = static_cast<std::uint32_t>(made.whole.mesh.nodes.size())};
  attempt.free_share = failed->free_share;
  attempt.mesh = std::move(made);
  return attempt;
}

constexpr std::uint64_t kOtherSeed = 0x5EED;

// Of 136 attempts of the campaign 9 needed a larger patch than that of reach 4, 22 than of 3.5 and
// 3 than of 5; but with 5 the patches of the cases are a tenth to a half larger.
constexpr std::array kStrategies{
    Strategy{MeshStrategy::Unchanged, "unchanged", is_same_model, keep_mesh, Reuse::Mesh},
    Strategy{MeshStrategy::Morphed, "held", is_to_be_held, hold, Reuse::Mesh},
    Strategy{MeshStrategy::Morphed, "morphed", may_morph, morph, Reuse::Mesh},
    Strategy{MeshStrategy::Local, "local, 4 edge lengths", has_patches, remesh_nodes, Reuse::Nodes,
             4},
    Strategy{MeshStrategy::Local, "local, 6 edge lengths", needs_larger_patch, remesh_nodes,
             Reuse::Nodes, 6},
    Strategy{MeshStrategy::Local, "local, 8 edge lengths", needs_larger_patch, remesh_nodes,
             Reuse::Nodes, 8, true},
    Strategy{MeshStrategy::Local, "local, refined", has_places_in_patches, remesh_nodes,
             Reuse::Nodes, 8, true, 0, "made anew there, finer", 0.5},
    Strategy{MeshStrategy::Local, "local, everywhere", may_place_nodes, remesh_nodes, Reuse::Nodes,
             HUGE_VAL},
    Strategy{MeshStrategy::Full, "full", may_free_nodes, remesh_nodes, Reuse::FreedNodes, HUGE_VAL,
             false, 0, "all nodes were optimised anew"},
    Strategy{MeshStrategy::Fresh, "fresh", may_place_nodes, remesh_nodes, Reuse::Nothing, HUGE_VAL,
             false, kOtherSeed, "meshed from another seed"},
    Strategy{MeshStrategy::Fresh, "fresh, refined", has_places, remesh_nodes, Reuse::Nothing,
             HUGE_VAL, false, 0, "made finer there", 0.5},
    Strategy{MeshStrategy::TetGen, "TetGen", always, by_tetgen, Reuse::Nothing, HUGE_VAL, false, 0,
             "meshed by TetGen"}};

constexpr Strategy kRenewed{MeshStrategy::Renewed, "renewed",      always,
                            remesh_nodes,          Reuse::Nothing, HUGE_VAL};

/// Makes an attempt by the strategy and times it.
Attempt timed(const Strategy& how, const Problem& problem, const Attempt* failed) {
  const Stopwatch watch;
  Attempt attempt = how.make(how, problem, failed);
  attempt.seconds.total = watch.total();
  attempt.copies = how.reuse != Reuse::Nothing;
  return attempt;
}

/// Makes and times an attempt; an Error that it throws also lists what was tried before.
Attempt attempted(const Strategy& how, const Problem& problem, const Attempt* failed,
                  const Report& report) {
  try {
    return timed(how, problem, failed);
  } catch (Error& error) {
    std::vector<std::string> all = in_words(report.attempts);
    std::ranges::move(error.info().attempts, std::back_inserter(all));
    error.info().attempts = std::move(all);
    throw;
  }
}

/// The fault of an attempt's mesh; where none was described, as before there was a mesh, the reason
/// why the attempt was given up.
Warning fault_of(const Attempt& failed) {
  return failed.fault.value_or(Warning{.code = WarningCode::Fallback, .message = failed.reason});
}

/// What was wrong with an attempt, and what is done instead.
Warning made_instead(const Attempt& failed, const char* instead) {
  Warning warning = fault_of(failed);
  warning.message += std::string("; ") + instead;
  return warning;
}

/// The error after two hopeless attempts: no mesh is to be had. It has the fault of the one with
/// more features at its place.
Error refusal(const Attempt& one, const Attempt& other, const Report& report) {
  Warning fault = fault_of(one);
  if (Warning second = fault_of(other); second.features.size() > fault.features.size())
    fault = std::move(second);
  Error error = error::boundary_not_recovered(fault.message, fault.point, fault.features);
  error.info().attempts = in_words(report.attempts);
  return error;
}

}  // namespace

std::span<const Strategy> strategies() { return kStrategies; }

std::span<const Strategy> tet_keeping_strategies() {
  const auto first_other = std::ranges::find_if(
      kStrategies, [](const Strategy& how) { return how.reuse != Reuse::Mesh; });
  return {kStrategies.begin(), first_other};
}

std::optional<Attempt> first_taken(const Problem& problem, Report& report,
                                   std::span<const Strategy> of) {
  std::optional<Attempt> failed;
  bool made_nodes = false;
  for (const Strategy& how : of) {
    if (how.reuse != Reuse::Mesh && !std::exchange(made_nodes, true)) {
      problem.run.warn(report.warnings);
      if (problem.run.on_warnings)
        problem.run.warn(names_to_be_lost(problem.parent, problem.modified.model,
                                          problem.modified.cells.boundary, problem.run));
    }
    Stopwatch watch;
    if (made_nodes) static_cast<void>(problem.plan());
    // Whether a strategy applies may depend on the plan too, for the edge lengths in it.
    const bool applies = how.applies(problem, failed ? &*failed : nullptr);
    watch.lap(report.seconds.difference);
    if (!applies) continue;
    if (how.instead != nullptr && failed) {
      report.warnings.push_back(made_instead(*failed, how.instead));
      problem.run.warn({&report.warnings.back(), 1});
    }
    report.strategy = how.kind;
    Attempt attempt = attempted(how, problem, failed ? &*failed : nullptr, report);
    add(report.seconds, attempt.seconds);
    const double seconds = attempt.seconds_of_its_own();
    std::ranges::move(attempt.tries, std::back_inserter(report.attempts));
    if (attempt.taken()) {
      report.taken = {attempt.name, "", seconds};
      return attempt;
    }
    if (attempt.reason.empty()) continue;  // the strategy does not suit the problem
    report.attempts.push_back({attempt.name, attempt.reason, seconds});
    if (attempt.hopeless && failed && failed->hopeless) throw refusal(attempt, *failed, report);
    if (how.reuse == Reuse::Mesh)
      report.warnings.insert(report.warnings.end(), attempt.warnings.begin(),
                             attempt.warnings.end());
    else if (attempt.serves)
      failed = std::move(attempt);
  }
  return std::nullopt;
}

Attempt regular_mesh(const Problem& problem) {
  const Stopwatch watch;
  try {
    return timed(kRenewed, problem, nullptr);
  } catch (const Error& e) {
    if (e.info().reason != "MESH_TOO_LARGE") throw;
    Attempt attempt(kRenewed.name);
    attempt.serves = false;
    attempt.reason = e.info().message;
    attempt.seconds.total = watch.total();
    return attempt;
  }
}

}  // namespace remeshd
