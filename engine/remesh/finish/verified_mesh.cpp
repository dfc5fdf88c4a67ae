// From the optimised nodes to a verified mesh.
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "engine/nodes/dump.h"
#include "engine/remesh/finish/patch_mesh.h"
#include "engine/remesh/finish/repair.h"
#include "engine/remesh/last_resort/confine.h"
#include "engine/remesh/steps.h"

namespace remeshd {
namespace {

struct Repairs {
  int rounds = 8;
  double fewer = 0.7;  ///< of the faults before a round, for the next to be made
  double few_inserted = 200, most_inserted = 0.2;
};
constexpr Repairs kRepairs;

/// Reuse of improved tets, clean-up, stitching into the parent's mesh, map and verification of an
/// extracted mesh. `clean_up`: false for a draft, to see whether the boundary is all there. Throws
/// PatchTooSmall.
void finish(Candidate& c, const MeshingTask& task, const MeshPatch& patch, bool clean_up) {
  put_back(c, cleaned_up(c, task, patch, clean_up), task, patch);
}

/// Finishes a mesh, with nodes inserted where the boundary is not all there: as long as the peeled
/// mesh shows that by itself, and then where verification finds it. Returns their number.
std::uint32_t finish_repaired(Candidate& c, const MeshingTask& task, const MeshPatch& patch,
                              const SampledBoundary& boundary) {
  const CellularModel& cells = task.cells;
  const SizeField& sizes = task.density.sizes;
  const bool clean_up = task.options.clean_up;
  const auto most = static_cast<std::uint32_t>(
      few_more_nodes(static_cast<double>(c.nodes.size() + c.nodes.elsewhere)));
  std::uint32_t repaired = 0;
  const auto insert_at = [&](std::span<const MeshDefect> defects) {
    const std::int32_t first = c.nodes.size();
    if (c.too_fine ||
        insert_where_missing(c.nodes, defects, cells.boundary, boundary.samples, sizes) == 0)
      return false;
    c.loop.mesh = with_nodes_inserted(c.loop.mesh, first, c.nodes, cells.boundary, sizes, task.run);
    repaired += c.nodes.size() - first;
    const double verified = c.verify_seconds;
    c = extract(std::move(c.nodes), std::move(c.loop), task, patch, boundary.inside);
    c.verify_seconds = verified;
    c.too_fine = repaired > most;
    return true;
  };
  int rounds_at_facets = 0;
  const auto insert_at_facets = [&] {
    for (; rounds_at_facets < kRepairs.rounds && !c.delaunay.nonconforming.empty();
         ++rounds_at_facets)
      if (!insert_at(nonconforming_facets(c.delaunay))) break;
  };
  insert_at_facets();
  // Where the peeled mesh lacks a part of the boundary, no clean-up brings it back.
  const bool sized = !task.options.sizing.even;
  const auto finish_complete = [&] {
    finish(c, task, patch, false);
    if (clean_up && boundary_is_complete(c.verification)) finish(c, task, patch, true);
  };
  if (sized && repaired > 0)
    finish_complete();
  else
    finish(c, task, patch, clean_up);
  const auto faults = [&] {
    const auto& counts = c.verification.counts;
    return std::accumulate(counts.begin(), counts.end(), 0.0);
  };
  double last = HUGE_VAL;
  for (int round = 0; round < kRepairs.rounds && !c.verification.valid; ++round) {
    if (sized && faults() > kRepairs.fewer * last) break;
    last = faults();
    if (!insert_at(c.verification.failures)) break;
    insert_at_facets();
    finish_complete();
  }
  return repaired;
}

}  // namespace

double few_more_nodes(double nodes) {
  return kRepairs.few_inserted + kRepairs.most_inserted * nodes;
}

Candidate extract_verified(const MeshingTask& task, PatchNodes local, OptimiseResult loop,
                           const SampledBoundary& boundary, Attempt& attempt) {
  Stopwatch watch;
  Candidate mesh =
      extract(std::move(local.nodes), std::move(loop), task, local.patch, boundary.inside);
  const std::uint32_t inserted = finish_repaired(mesh, task, local.patch, boundary);
  if (!mesh.verification.valid) confine(mesh, task, local.patch, boundary.inside, attempt);
  attempt.counts.nodes_inserted = inserted;
  dump_text(task.run, "09-verify", [&] { return to_text(mesh.verification); });
  if (inserted > 0)
    attempt.warnings.push_back({.code = WarningCode::NodesInserted,
                                .message = std::to_string(inserted) +
                                           " nodes were inserted to make the boundary complete"});
  watch.lap(attempt.seconds.extract);
  attempt.seconds.verify += mesh.verify_seconds;
  return mesh;
}

void judge(const Strategy& how, const Problem& problem, Attempt& attempt) {
  const Candidate& mesh = *attempt.candidate();
  const bool larger_patch = std::isfinite(how.reach) && !how.last_reach;
  if (mesh.verification.valid && (mesh.bad_at_interface == 0 || !larger_patch)) return;
  if (mesh.bad_at_interface > 0 && larger_patch && (mesh.verification.valid || mesh.too_fine)) {
    attempt.reason = std::to_string(mesh.bad_at_interface) +
                     " tets beside what stays of the base could not be cleaned up";
    return;
  }
  attempt.fault = describe_fault(mesh, problem);
  attempt.reason = attempt.fault->message;
  attempt.too_fine = mesh.too_fine;
  if (!mesh.too_fine) return;
  attempt.reason += "; its boundary takes far more nodes than were asked for";
  if (!problem.modified.options.sizing.even) attempt.hopeless = true;
}

}  // namespace remeshd
