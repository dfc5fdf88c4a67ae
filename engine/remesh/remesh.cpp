#include "engine/remesh/remesh.h"

#include <cmath>
#include <utility>

#include "engine/base/tolerance.h"
#include "engine/cellular/boundary_model/boundary_parts.h"
#include "engine/cellular/slits.h"
#include "engine/delivery/group_outcomes.h"
#include "engine/local_fuse/local_fuse.h"
#include "engine/model/selection/selection_error.h"
#include "engine/optimise/live_mesh.h"
#include "engine/remesh/complete.h"
#include "engine/remesh/steps.h"
#include "engine/remesh/strategies.h"

namespace remeshd {

namespace {

constexpr double kWidestSlit = 4;  // x the largest tiny motion: two features may move

/// Makes the cellular model (Sect. 4.1) of the revision's model, and keeps of the parent's what no
/// changed feature touches.
void build_geometry(const Revision& parent, Revision& revision, const Run& run) {
  const Stopwatch watch;
  Report& report = revision.report;
  revision.cells = build_cells(revision.model, parent.model, parent.cells, run);
  report.geometry = revision.cells.parts->geometry;
  double on_attempts = 0;
  for (const GeometryAttempt& attempt : revision.cells.geometry_attempts) {
    report.geometry_attempts.push_back({attempt.route, attempt.reason, attempt.seconds});
    on_attempts += attempt.seconds;
  }
  report.geometry_seconds += watch.total() - on_attempts;
}

/// Meshes the model by the first of the strategies that is taken. Returns false where none is.
bool mesh_by(std::span<const Strategy> strategies, const Revision& parent, Revision& revision,
             const Run& run, Stopwatch& watch) {
  Report& report = revision.report;
  // Density of new nodes: the parent's edge length, or what the options ask for (Sect. 7).
  const Density density =
      resolve_density(parent, revision.options, revision.model, revision.cells, run);
  revision.edge_length = report.edge_length = density.sizes.base();
  revision.rules_weakening = density.weakening;
  revision.sizes = density.sizes;
  revision.dense_places = density.dense_places;
  const std::vector<Warning> before = report.warnings;
  report.warnings.insert(report.warnings.end(), density.warnings.begin(), density.warnings.end());
  watch.lap(report.seconds.setup);

  run.report("difference", 0.06);
  const Problem problem(parent, revision, density, run);
  // Strategies in turn. Before the first that makes nodes the plan is made: copycells, newcells,
  // order of the sources (Sects. 4.2, 4.3, 6.2, 6.3; step 1 of Sect. 5).
  std::optional<Attempt> taken = first_taken(problem, report, strategies);
  if (!taken) {
    report.warnings = before;
    return false;
  }
  complete(*std::move(taken), problem, revision, watch);
  return true;
}

/// Whether the boundary has steps or slits as narrow as those that tiny motions of features leave.
bool has_tiny_slits(const BoundaryModel& boundary) {
  return has_slits(boundary, kWidestSlit * tolerance::kTinyMotion * boundary.bounds.diagonal());
}

Warning left_out(const std::vector<std::string>& features) {
  return {
      .code = WarningCode::DetailNotResolved,
      .message = first_and_more(features) + " moved by next to nothing, which the mesh leaves out",
      .features = features};
}

/// Meshes the model with those features put back that have moved by next to nothing: no tets fit
/// into the steps and slits that they leave beside others. Exact volume and areas stay those of the
/// model that was asked for.
void mesh_without(const TinyMotions& tiny, const Revision& parent, Revision& revision,
                  const Run& run, Stopwatch& watch) {
  Report& report = revision.report;
  const double exact_volume = revision.cells.volume;
  revision.meshed_source = tiny.source;
  revision.model = revision.meshed_model = evaluate(tiny.source);
  build_geometry(parent, revision, run);
  report.warnings.push_back(left_out(tiny.features));
  run.warn({&report.warnings.back(), 1});
  mesh_by(strategies(), parent, revision, run, watch);
  report.exact_volume = exact_volume;
}

}  // namespace

std::vector<GroupFigures> check_groups(const Revision& parent, const FeatureModel& model,
                                       const BoundaryModel& boundary, const Run& run) {
  std::vector<GroupFigures> figures = groups_before_meshing(model, boundary, run);
  check_areas(parent, model, figures);
  const std::vector<std::string> empty = groups_of_nothing(model, boundary, run);
  if (parent.model.features.empty() && !empty.empty()) throw error::empty_group(empty.front());
  check_emptied(model, empty);
  return figures;
}

Revision make_revision(const Revision& parent, const ModelSource& document,
                       const MeshOptions& options, const Run& run) {
  Stopwatch watch;
  Revision revision;
  revision.source = revision.meshed_source = document;
  revision.model = revision.meshed_model = evaluate(document);
  revision.options = options;
  run.report("cells", 0);
  build_geometry(parent, revision, run);
  revision.report.figures = check_groups(parent, revision.model, revision.cells.boundary, run);
  const bool first = parent.model.features.empty();
  const TinyMotions tiny = first || options.sizing.even
                               ? TinyMotions{}
                               : without_tiny_motions(document, parent.meshed_source);
  if (tiny.features.empty() || !has_tiny_slits(revision.cells.boundary))
    mesh_by(strategies(), parent, revision, run, watch);
  else if (!mesh_by(tet_keeping_strategies(), parent, revision, run, watch))
    mesh_without(tiny, parent, revision, run, watch);
  return revision;
}

Attempt remesh_nodes(const Strategy& how, const Problem& problem, const Attempt* failed) {
  Attempt attempt(how.name);
  // It has the plan, which tells where material is copied from.
  const MeshingTask task(how, problem, failed);
  try {
    // Nodes are copied to copycells (Sect. 6.4) and filled into newcells (Sects. 3.2, 7), fixed and
    // free: steps 2 and 3 of Sect. 5.
    std::optional<PatchNodes> nodes = copy_and_fill(task, attempt);
    if (!nodes) return attempt;
    // Variational tetrahedral meshing of the free nodes (Sects. 3.1, 3.3, 8): step 4 of Sect. 5.
    const SampledBoundary boundary = sample(task, *nodes, attempt);
    OptimiseResult loop = optimise(task, *nodes, boundary, attempt);
    // Extraction of the model's mesh (Sect. 3.4), put back into the parent's and verified.
    attempt.mesh = extract_verified(task, std::move(*nodes), std::move(loop), boundary, attempt);
    judge(how, problem, attempt);
    attempt.refined_at = task.refined_at;
    if (how.refined > 0 && attempt.taken())
      attempt.last_resort_share =
          std::fmax(attempt.last_resort_share,
                    share_in(region_of(task.refined_at, problem.density.sizes), attempt));
  } catch (const PatchTooSmall& where) {
    attempt.reason = std::string("the part cut out of the base did not suffice for ") + where.where;
  }
  return attempt;
}

}  // namespace remeshd
