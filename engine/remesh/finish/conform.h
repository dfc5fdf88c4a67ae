#pragma once

#include <cstdint>

#include "engine/patch/candidate.h"
#include "engine/patch/patch.h"
#include "engine/remesh/steps.h"

namespace remeshd {

/// Finishes an extracted mesh: reuse of improved tets, clean-up, stitching into the parent's mesh,
/// verification. Where the mesh lacks a part of the boundary, nodes are inserted and it is
/// extracted anew: near facets of the peeled mesh that lie on no face of the model, as long as
/// there are any, then where verification finds the boundary wrong. Before each extraction, the
/// segments of model edges that the new nodes break are recovered. It ends with a valid mesh, or
/// when nothing helps any more: the verification then says what is missing, and where.
///
/// Returns the number of nodes inserted. Throws PatchTooSmall.
std::uint32_t conform(Candidate& c, const MeshingTask& task, const MeshPatch& patch,
                      const SampledBoundary& boundary);

}  // namespace remeshd
