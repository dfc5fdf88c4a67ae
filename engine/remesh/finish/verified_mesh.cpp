// From the optimised nodes to a verified mesh.
#include <cmath>
#include <string>
#include <utility>

#include "engine/nodes/dump.h"
#include "engine/remesh/finish/conform.h"
#include "engine/remesh/finish/patch_mesh.h"
#include "engine/remesh/last_resort/confine.h"
#include "engine/remesh/steps.h"

namespace remeshd {

Candidate extract_verified(const MeshingTask& task, PatchNodes local, OptimiseResult loop,
                           const SampledBoundary& boundary, Attempt& attempt) {
  Stopwatch watch;
  Candidate mesh =
      extract(std::move(local.nodes), std::move(loop), task, local.patch, boundary.inside);
  const std::uint32_t inserted = conform(mesh, task, local.patch, boundary);
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
