#pragma once

#include <cstdint>

#include "engine/patch/candidate.h"
#include "engine/patch/patch.h"
#include "engine/remesh/steps.h"

namespace remeshd {

/// Finishes an extracted mesh (reuse of improved tets, clean-up, stitching into the parent's mesh,
/// verification), with nodes inserted where it has not all of the boundary: near facets of the
/// peeled mesh that lie on no face of the model, as long as there are any, then where verification
/// finds the boundary wrong; each time, segments of model edges that this breaks are recovered
/// first. It ends with a mesh that is valid, or when nothing helps any more: the verification says
/// what is missing, and where.
///
/// Returns the number of nodes inserted. Throws PatchTooSmall.
std::uint32_t conform(Candidate& c, const MeshingTask& task, const MeshPatch& patch,
                      const SampledBoundary& boundary);

}  // namespace remeshd
