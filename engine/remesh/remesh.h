#pragma once

#include <vector>

#include "engine/base/run.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// The whole road of the paper: from a model document (and, for an edit, the original revision) to
/// a checked mesh with its maps. A first mesh is a remesh whose cells are all new
/// (`parent` is `Revision::none()`).
///
/// A remesh whose quality has drifted is made anew, as a regular mesh, and the Report says so:
/// where its mean volume-length lies more than 0.005 (0.04 unless the mesh is even) below that of
/// the chain's last regular mesh, or the nodes of an even mesh are more than a tenth off in number,
/// and the regular mesh is better. The first edit of a regular mesh is never made anew for that.
///
/// The result depends on the arguments alone, not on `run.threads` or the clock. `run.on_warnings`
/// is called with the warnings so far and the names that will be lost, before nodes are made, and
/// with the last mesh's fault before a strategy that tells what is done instead.
/// Throws Error: what `evaluate` and `build_cells` throw; `OPTIONS_INVALID`; `SELECTOR_EMPTY` where
/// a group or size control of a first mesh selects nothing; `POLICY_BROKEN` for a group;
/// `MESH_TOO_LARGE` where more nodes than `run.max_nodes` would be needed, before they are
/// optimised; `BOUNDARY_NOT_RECOVERED` where no valid mesh could be made, naming the place and the
/// features there; `TETGEN_MISSING`, and with the control mesh as inside test the other failures of
/// TetGen; Cancelled within 100 ms of a stop request.
Revision make_revision(const Revision& parent, const ModelSource& source,
                       const MeshOptions& options, const Run& run);

/// Checks the groups of a model and their policies as far as no mesh is needed for that, as
/// `make_revision` does before it meshes. Returns the groups with their exact areas.
///
/// `parent`: as for `make_revision`; `boundary`: the model's. Throws Error: `SELECTOR_EMPTY` where
/// a group of a first mesh selects nothing; `POLICY_BROKEN`.
std::vector<GroupFigures> check_groups(const Revision& parent, const FeatureModel& model,
                                       const BoundaryModel& boundary, const Run& run);

}  // namespace remeshd
