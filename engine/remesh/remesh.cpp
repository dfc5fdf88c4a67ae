#include "engine/remesh/remesh.h"

#include <utility>

#include "engine/cellular/boundary_parts.h"
#include "engine/remesh/continuation.h"
#include "engine/remesh/deliver.h"
#include "engine/remesh/lost_names.h"
#include "engine/remesh/master.h"
#include "engine/remesh/shortfalls.h"
#include "engine/remesh/stopwatch.h"
#include "engine/remesh/trial.h"
#include "engine/remesh/ways.h"
#include "engine/remesh/wear.h"

namespace remeshd {

namespace {

/// The same geometry as the original's: its mesh, every node and tet kept.
void repeat(const Revision& original, Revision& revision, const Run& run) {
  deliver_kept(original, original.delivery.mesh.nodes, {}, revision);
  revision.anchor = original.anchor;
  revision.reference = original.reference;
  revision.meshed_source = original.meshed_source;
  revision.meshed_model = original.meshed_model;
  revision.report.groups = original.report.groups;
  revision.report.verification = original.report.verification;
  revision.report.verification.tets_inherited +=
      std::exchange(revision.report.verification.tets_proved, 0);
  revision.report.way = Way::Unchanged;
  account(&original, {}, original.report.volume, revision, run);
}

/// Nearly the same geometry: the connectivity of the original's mesh, where that serves.
bool continue_with(const Revision& original, Revision& revision, const Run& run) {
  const Trial trial("morphed");
  auto result = continue_mesh(original, revision, run);
  if (const auto* why = std::get_if<NotContinued>(&result)) {
    if (why->empty()) return false;
    revision.report.attempts.push_back(trial.given_up(*why));
    revision.report.warnings.push_back(
        {.code = WarningCode::Fallback, .message = "the connectivity could not be kept: " + *why});
    return false;
  }
  auto& mesh = std::get<ContinuedMesh>(result);
  revision.report.seconds.verify += mesh.verify_seconds;
  revision.report.verification = figures_of(mesh.verification);
  deliver_kept(original, std::move(mesh.mesh.nodes), mesh.verification.changed_tets, revision);
  const Membership membership(revision.model);
  name_delivery(mesh.verification.surface, mesh.supports, membership, {}, revision, run);
  const FeatureModel& made_for = original.master_model();
  revision.anchor = std::make_shared<const Anchor>(
      Anchor{original.anchor ? original.anchor->source : original.meshed_source, made_for,
             original.master_nodes(), std::move(mesh.supports)});
  revision.reference = original.reference;
  revision.report.way = Way::Morphed;
  revision.report.free_share =
      mesh.nodes_moved / static_cast<double>(revision.delivery.mesh.nodes.size());
  account(&original, mesh.verification.changed_tets, mesh.verification.volume, revision, run);
  return true;
}

/// Whether an edit with these options may answer with the tets of its base.
bool keeps_connectivity(const Revision& original, const MeshOptions& options) {
  return !options.nodes && !options.size && options.clean_up == original.options.clean_up &&
         options.threshold == original.options.threshold;
}

/// Puts a regular mesh in the place of a remesh that has worn, where it is better.
void renew_if_worn(const Revision& original, Ways& ways, Revision& revision, const Run& run) {
  const WearReference now = wear_reference(revision);
  if (is_regular(original) || !worn(now, original.reference)) return;
  const Report as_remeshed = revision.report;
  const Attempt remesh = ways.last_given_up("the mesh had worn: " + describe(now));
  NewMesh made = ways.regular(revision.options.seed, "renewed");
  Revision anew = revision;
  const bool valid = made.candidate.verification.valid;
  const std::string fault = valid ? "" : ways.fault_of(made);
  if (valid) deliver(std::move(made.candidate), nullptr, &original, *made.source, anew, run);
  anew.reference = wear_reference(anew);
  if (valid && worn(now, anew.reference)) {
    revision = std::move(anew);
    revision.report.way = Way::Renewed;
    revision.report.attempts.push_back(remesh);
    revision.report.warnings.push_back({.code = WarningCode::Renewed,
                                        .message = "the mesh had worn (" + describe(now) +
                                                   ") and was made anew (" +
                                                   describe(revision.reference) + ")"});
    return;
  }
  const PhaseSeconds spent = revision.report.seconds;
  revision.report = as_remeshed;
  revision.report.seconds = spent;
  revision.report.attempts.push_back(ways.last_given_up(
      valid ? "no better than the mesh that had worn: " + describe(anew.reference) : fault));
  revision.reference = now;
}

/// What a finished mesh lacks, beside what was told on the way.
void add_warnings(const Revision* original, Revision& revision) {
  std::vector<Warning>& warnings = revision.report.warnings;
  for (auto& found : {lost_names(original, revision), shortfalls(revision)})
    warnings.insert(warnings.end(), found.begin(), found.end());
}

/// Tets that an edit keeps are as likely of a last resort as those of its base.
double last_resort_share(const Revision* original, const Report& report) {
  if (report.way == Way::TetGen) return 1;
  if (original == nullptr || report.counts.tets == 0) return 0;
  return original->report.last_resort_share * report.counts.tets_kept / report.counts.tets;
}

}  // namespace

const FeatureModel& Revision::master_model() const { return anchor ? anchor->model : meshed_model; }

const Pages<Vec3>& Revision::master_nodes() const {
  return anchor ? anchor->nodes : delivery.mesh.nodes;
}

const Pages<Support>& Revision::supports() const {
  return anchor ? anchor->supports : master->supports;
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
  revision.cells = original ? build_cells(revision.model, original->model, original->cells, run)
                            : build_cells(revision.model, run);
  const CellularModel& cells = revision.cells;
  report.geometry = cells.parts->geometry;
  const Density density = resolve_density(original, options, cells, run);
  revision.edge_length = report.edge_length = density.edge_length;
  watch.lap(seconds.setup);

  run.report("difference", 0.06);
  if (original && keeps_connectivity(*original, options)) {
    const bool same = same_geometry(original->meshed_model, revision.model);
    if (same) repeat(*original, revision, run);
    if (same || continue_with(*original, revision, run)) {
      report.last_resort_share = original->report.last_resort_share;
      add_warnings(original, revision);
      watch.lap(seconds.copy);
      seconds.total = watch.total();
      return revision;
    }
  }
  run.warn(report.warnings);
  if (run.on_warnings) run.warn(names_to_be_lost(original, revision.model, cells.boundary));
  Ways ways(original, revision, density, watch, run);
  NewMesh made = ways.first_valid();
  deliver(std::move(made.candidate), made.copied_from, original, *made.source, revision, run);

  const bool by_rule = original && !options.nodes && !options.size;
  revision.reference =
      by_rule && report.way != Way::Fresh ? original->reference : wear_reference(revision);
  if (by_rule && made.copied_from) renew_if_worn(*original, ways, revision, run);
  report.last_resort_share = last_resort_share(original, report);
  add_warnings(original, revision);
  watch.lap(seconds.extract);
  seconds.total = watch.total();
  return revision;
}

}  // namespace remeshd
