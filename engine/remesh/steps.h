#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "engine/base/inside_test.h"
#include "engine/boundary/samples.h"
#include "engine/optimise/optimise.h"
#include "engine/patch/candidate.h"
#include "engine/patch/patch.h"
#include "engine/remesh/attempt.h"
#include "engine/remesh/strategies.h"

namespace remeshd {

// The steps of remesh_nodes (remesh.cpp). Each writes its counts and seconds into the attempt.

/// What a strategy makes a mesh of: the parent's nodes, as far as the plan copies them, and target
/// edge lengths. Keeps references.
class MeshingTask {
 private:
  std::unique_ptr<const CopyPlan> own_plan_;  // before `plan`, which may be this

 public:
  /// `failed`: the last attempt that made nodes; null if none did.
  MeshingTask(const Strategy& how, const Problem& problem, const Attempt* failed);

  const Revision& parent;  ///< what nodes are copied from; `Revision::none()` where all are new
  const CopyPlan& plan;    ///< from `parent` to the modified model
  const CellularModel& cells;
  const MeshOptions& options;
  Density density;
  std::uint64_t seed;
  bool all_free;                 ///< copied nodes are optimised too, all of them
  double reach;                  ///< how far from what changes the parent is cut open; length
  std::vector<Vec3> refined_at;  ///< where the last mesh was wrong, for a strategy that refines
  const EntityMap* entities;     ///< for nodes outside of the patch; null where there are none
  const Run run;                 ///< with a folder of its own for dumps: `4-local-4-edge-lengths`
};

/// Copied and new nodes, free and fixed (Sects. 6 and 7), with the patch of the parent's mesh that
/// they are put into. Returns nothing, and says why in the attempt, where a node that stays stands
/// on nothing that the modified boundary has.
std::optional<PatchNodes> copy_and_fill(const MeshingTask& task, Attempt& attempt);

/// The modified boundary as the optimisation sees it.
struct SampledBoundary {
  Samples samples;    ///< near nodes that are free or have to find what they stand on
  InsideTest inside;  ///< keeps a reference to the task's plan
};

/// Samples the boundary (Sect. 3.1) and places the fixed nodes that have to find what they stand
/// on. Throws what ControlMesh::build throws.
SampledBoundary sample(const MeshingTask& task, PatchNodes& nodes, Attempt& attempt);

/// Runs the optimisation loop (Sect. 8), which starts from the Delaunay mesh of the fixed nodes,
/// then inserts nodes in missing segments of model edges. Throws PatchTooSmall.
OptimiseResult optimise(const MeshingTask& task, PatchNodes& nodes, const SampledBoundary& boundary,
                        Attempt& attempt);

/// The peeled Delaunay mesh of the optimised nodes, cleaned up, put back into the parent's mesh and
/// verified, with nodes inserted where the boundary is not all there. Throws PatchTooSmall.
Candidate extract_verified(const MeshingTask& task, PatchNodes nodes, OptimiseResult loop,
                           const SampledBoundary& boundary, Attempt& attempt);

/// Decides whether the attempt's mesh is taken. Where not, it sets the attempt's reason: the mesh
/// is not valid, or, where a larger patch will be tried, could not be cleaned up at the interface.
void judge(const Strategy& how, const Problem& problem, Attempt& attempt);

/// The most nodes that may be inserted beside `nodes`: a boundary that would need more has details
/// far finer than the edge length.
double few_more_nodes(double nodes);

}  // namespace remeshd
