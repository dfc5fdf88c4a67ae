#pragma once

#include "engine/kernel/tetgen.h"
#include "engine/mesh/quality_goals.h"
#include "engine/patch/candidate.h"
#include "engine/plan/copy_plan.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

/// What a mesh of last resort is made of. Keeps references.
struct TetGenInput {
  const FeatureModel& model;
  const CopyPlan& plan;  ///< `plan_of_nothing`: it copies nothing
  const CellularModel& cells;
  SizeField sizes;                       ///< target edge lengths
  bool clean_up = true;                  ///< as in MeshOptions
  double threshold = goals::kThreshold;  ///< as in MeshOptions
  kernel::TetGenLimits limits = {};      ///< of TetGen; the time is for all tries together
};

/// The mesher of last resort: TetGen's mesh of a conforming surface mesh, cleaned up and verified.
/// All nodes are new. Where TetGen fails, or its mesh does not verify, the surface is made finer,
/// then TetGen may add points on it. A mesh of very many more nodes than the edge length asks for,
/// as a film or a razor-thin gap would need, is refused: nobody has asked for it. No other surface
/// is tried where nothing is wrong but flat tets: there the model is flat.
///
/// Post: a valid candidate, with the tries that were given up before. Its `loop.mesh` is the
/// Delaunay mesh of the output mesh's nodes, its `delaunay` what peeling leaves of that: it may
/// lack parts of the boundary. Throws what mesh_surface and run_tetgen throw;
/// Error(BOUNDARY_NOT_RECOVERED) where no mesh was valid. TETGEN_TOO_SLOW is not followed by
/// another try: a clock decides on errors, never on meshes.
Candidate mesh_by_tetgen(const TetGenInput& input, const Run& run);

/// The same after other ways to a mesh have failed, the last with the defects in `failed`.
///
/// Throws Error(BOUNDARY_NOT_RECOVERED) where TetGen fails too. It names the place and the features
/// of the first defect of TetGen's last mesh; where the last try gave no mesh, of the first one in
/// `failed`, and why TetGen failed. Passes on Cancelled and TETGEN_MISSING.
Candidate tetgen_mesh(const TetGenInput& input, const Verification& failed, const Run& run);

}  // namespace remeshd
