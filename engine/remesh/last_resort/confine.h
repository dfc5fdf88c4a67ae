#pragma once

#include "engine/patch/candidate.h"
#include "engine/patch/patch.h"
#include "engine/remesh/attempt.h"
#include "engine/remesh/steps.h"

namespace remeshd {

/// The local last resort for a mesh that is not valid: refills it round the places where it is
/// wrong (`refill`). Each further try takes out more round these places, or uses smaller boundary
/// facets where the refill before was wrong. A mesh that took too many nodes and is still wrong all
/// over is left alone.
///
/// Post: `candidate` is valid, with a warning in `attempt` and the share of the tets that were made
/// anew; or it is still wrong, and `attempt` has what was tried. Throws PatchTooSmall, and what
/// `refill` throws.
void confine(Candidate& candidate, const MeshingTask& task, const MeshPatch& patch,
             const InsideTest& inside, Attempt& attempt);

}  // namespace remeshd
