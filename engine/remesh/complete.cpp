#include "engine/remesh/complete.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/delivery/deliver.h"
#include "engine/delivery/group_outcomes.h"
#include "engine/delivery/lost_names.h"
#include "engine/delivery/quality_drift.h"
#include "engine/delivery/shortfalls.h"
#include "engine/model/selection/selection_error.h"
#include "engine/remesh/node_sizes.h"
#include "engine/remesh/strategies.h"
#include "engine/revision/group_members.h"
#include "engine/second_order/mid_nodes.h"

namespace remeshd {
namespace {

/// The parent's mesh, every node and tet kept.
void deliver_unchanged(const Revision& parent, Revision& revision, const Run& run) {
  deliver_kept(parent, parent.output.mesh.nodes, {}, revision);
  revision.anchor = parent.anchor;
  revision.meshed_source = parent.meshed_source;
  revision.meshed_model = parent.meshed_model;
  revision.report.groups = parent.report.groups;
  revision.report.verification = parent.report.verification;
  revision.report.verification.tets_inherited +=
      std::exchange(revision.report.verification.tets_proved, 0);
  account(parent, {}, parent.report.volume, revision, run);
}

/// The parent's tets over nodes that followed the surfaces.
void deliver_morphed(MorphedMesh mesh, double free_share, const Revision& parent,
                     Revision& revision, const Run& run) {
  revision.report.verification = figures_of(mesh.verification);
  deliver_kept(parent, std::move(mesh.mesh.nodes), mesh.verification.changed_tets, revision);
  const Membership membership(revision.model);
  name_output(mesh.verification.surface, mesh.supports, membership, {}, revision, run);
  revision.anchor = std::make_shared<const Anchor>(
      Anchor{parent.anchor ? parent.anchor->source : parent.meshed_source, parent.delaunay_model(),
             parent.delaunay_nodes(), std::move(mesh.supports)});
  revision.report.free_share = free_share;
  account(parent, mesh.verification.changed_tets, mesh.verification.volume, revision, run);
}

void deliver(Attempt taken, const Problem& problem, Revision& revision) {
  const Revision& parent = problem.parent;
  Report& report = revision.report;
  report.counts = std::move(taken.counts);
  report.free_share = taken.free_share;
  report.warnings.insert(report.warnings.end(), taken.warnings.begin(), taken.warnings.end());
  if (auto* mesh = std::get_if<Candidate>(&taken.mesh))
    deliver(std::move(*mesh), taken.copies ? parent : Revision::none(), parent, problem.plan(),
            revision, problem.run);
  else if (auto* morphed = std::get_if<MorphedMesh>(&taken.mesh))
    deliver_morphed(std::move(*morphed), taken.free_share, parent, revision, problem.run);
  else
    deliver_unchanged(parent, revision, problem.run);
}

/// Puts a regular mesh in the place of a remesh whose quality has drifted, where it is better.
/// Returns the share of the regular mesh's tets that a last resort made; nothing where the remesh
/// stays. `warnings`: those that are not of the remesh.
std::optional<double> renew_if_drifted(const Problem& problem, double seconds_of_remesh,
                                       const std::string& remesh,
                                       const std::vector<Warning>& warnings, Revision& revision) {
  const QualityReference now = quality_reference(revision);
  const bool even = revision.options.sizing.even;
  Report& report = revision.report;
  if (is_regular(problem.parent) || !has_drifted(now, problem.parent.reference, even)) return {};
  Attempt regular = regular_mesh(problem);
  add(report.seconds, regular.seconds);
  const TriedStrategy drifted{remesh, "the quality had drifted: " + describe(now),
                              seconds_of_remesh};
  TriedStrategy rejected{regular.name, regular.reason, regular.seconds_of_its_own()};
  const std::vector<TriedStrategy> tries = regular.tries;
  if (regular.taken()) {
    const double last_resort = regular.last_resort_share;
    Revision anew = revision;
    anew.report.warnings = warnings;
    deliver(std::move(regular), problem, anew);
    anew.reference = quality_reference(anew);
    if (has_drifted(now, anew.reference, even)) {
      anew.report.attempts.push_back(drifted);
      anew.report.attempts.insert(anew.report.attempts.end(), tries.begin(), tries.end());
      anew.report.warnings.push_back({.code = WarningCode::Renewed,
                                      .message = "the quality had drifted (" + describe(now) +
                                                 ") and was made anew (" +
                                                 describe(anew.reference) + ")"});
      anew.report.strategy = MeshStrategy::Renewed;
      anew.report.taken = {rejected.strategy, "", rejected.seconds};
      revision = std::move(anew);
      return last_resort;
    }
    rejected.reason = "no better than the mesh that had drifted: " + describe(anew.reference);
  }
  report.attempts.insert(report.attempts.end(), tries.begin(), tries.end());
  report.attempts.push_back(std::move(rejected));
  revision.reference = now;
  return {};
}

/// Whether the tets of the parent were kept, wherever their nodes went.
bool keeps_tets(MeshStrategy strategy) {
  return strategy == MeshStrategy::Unchanged || strategy == MeshStrategy::Morphed;
}

/// Share of the tets that a last resort made: `made` by this attempt, and of the tets that were
/// kept the share that the parent has.
double last_resort_share(const Revision& parent, const Report& report, double made) {
  if (report.strategy == MeshStrategy::TetGen) return 1;
  if (report.counts.tets == 0) return 0;
  return made + parent.report.last_resort_share * report.counts.tets_kept / report.counts.tets;
}

/// The error of a group of a first mesh that has neither facets nor tets.
Error without_members(const std::string& group, const Revision& revision) {
  const auto& figures = revision.report.figures;  // exact areas, from before meshing
  const auto found = std::ranges::find(figures, group, &GroupFigures::group);
  const double area = found == figures.end() ? 0 : found->exact_area.value_or(0);
  return area > 0 ? error::group_without_facets(group, area) : error::empty_group(group);
}

/// Finds what the model's groups have of the mesh and what became of them, and checks their
/// policies.
void complete_groups(const Revision& parent, Revision& revision) {
  OutputMesh& output = revision.output;
  output.groups.of_model = group_members(output, revision.model);
  const std::vector<std::string> empty = empty_groups(output);
  if (parent.model.features.empty() && !empty.empty())
    throw without_members(empty.front(), revision);
  check_emptied(revision.model, empty);
  revision.report.figures = group_outcomes(parent, revision, revision.report.figures);
}

}  // namespace

void complete(Attempt taken, const Problem& problem, Revision& revision, Stopwatch& watch) {
  const Revision& parent = problem.parent;
  Report& report = revision.report;
  const bool new_nodes = taken.candidate() != nullptr;
  // What a last resort made is no drift: a regular mesh would need it too.
  const bool resorted = taken.last_resort_share > 0;
  const bool renewable = new_nodes && taken.copies && problem.density.inherited && !resorted;
  const std::string name = taken.name;
  const double seconds = taken.seconds.total;
  double made_anew = taken.last_resort_share;
  const std::vector<Warning> warnings = report.warnings;
  deliver(std::move(taken), problem, revision);
  const bool begins_anew =
      !problem.density.inherited || report.strategy == MeshStrategy::Fresh || resorted;
  revision.reference = begins_anew ? quality_reference(revision) : parent.reference;
  if (renewable)
    made_anew = renew_if_drifted(problem, seconds, name, warnings, revision).value_or(made_anew);
  const bool same_tets = keeps_tets(report.strategy);
  revision.output.node_sizes =
      made_for(parent, revision, same_tets ? nullptr : &problem.plan(), problem.run);
  revision.output.mids = {.next_id = parent.output.mids.next_id};
  if (revision.options.order == 2) add_mid_nodes(parent, revision, problem.run);
  complete_groups(parent, revision);
  report.last_resort_share = last_resort_share(parent, report, made_anew);
  for (auto& found : {lost_names(parent, revision, problem.run), shortfalls(revision)})
    report.warnings.insert(report.warnings.end(), found.begin(), found.end());
  report.seconds.total = watch.total();
  const PhaseSeconds& s = report.seconds;
  // The time that no step has counted: names, maps and figures.
  (new_nodes ? report.seconds.extract : report.seconds.copy) +=
      s.total - (s.setup + s.optimise + s.extract + s.difference + s.copy);
}

}  // namespace remeshd
