#include "engine/remesh/remesh.h"

#include <cmath>
#include <utility>

#include "engine/cellular/boundary_model/boundary_parts.h"
#include "engine/delivery/group_outcomes.h"
#include "engine/local_fuse/local_fuse.h"
#include "engine/model/selection/selection_error.h"
#include "engine/optimise/live_mesh.h"
#include "engine/remesh/complete.h"
#include "engine/remesh/steps.h"
#include "engine/remesh/strategies.h"

namespace remeshd {

Revision make_revision(const Revision& parent, const ModelSource& document,
                       const MeshOptions& options, const Run& run) {
  Stopwatch watch;
  Revision revision;
  Report& report = revision.report;
  revision.source = revision.meshed_source = document;
  revision.model = revision.meshed_model = evaluate(document);
  revision.options = options;
  run.report("cells", 0);
  // The cellular model (Sect. 4.1), of which all is kept that no changed feature touches.
  revision.cells = build_cells(revision.model, parent.model, parent.cells, run);
  report.geometry = revision.cells.parts->geometry;
  report.geometry_seconds = watch.total();
  for (const GeometryAttempt& attempt : revision.cells.geometry_attempts) {
    report.geometry_attempts.push_back({attempt.route, attempt.reason, attempt.seconds});
    report.geometry_seconds -= attempt.seconds;
  }
  // Groups and their policies, which no mesh is needed for.
  report.figures = groups_before_meshing(revision.model, revision.cells.boundary, run);
  check_areas(parent, revision.model, report.figures);
  const std::vector<std::string> empty =
      groups_of_nothing(revision.model, revision.cells.boundary, run);
  if (parent.model.features.empty() && !empty.empty()) throw error::empty_group(empty.front());
  check_emptied(revision.model, empty);
  // Density of new nodes: the parent's edge length, or what the options ask for (Sect. 7).
  const Density density = resolve_density(parent, options, revision.model, revision.cells, run);
  revision.edge_length = report.edge_length = density.sizes.base();
  revision.rules_weakening = density.weakening;
  revision.sizes = density.sizes;
  revision.dense_places = density.dense_places;
  report.warnings = density.warnings;
  watch.lap(report.seconds.setup);

  run.report("difference", 0.06);
  const Problem problem(parent, revision, density, run);
  // Strategies in turn. Before the first that makes nodes the plan is made: copycells, newcells,
  // order of the sources (Sects. 4.2, 4.3, 6.2, 6.3; step 1 of Sect. 5).
  Attempt taken = first_taken(problem, report);
  complete(std::move(taken), problem, revision, watch);
  return revision;
}

Attempt remesh_nodes(const Strategy& how, const Problem& problem, const Attempt* failed) {
  Attempt attempt(how.name);
  // With the plan, which tells where material is copied from.
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
