#pragma once

#include "engine/patch/candidate.h"
#include "engine/patch/patch.h"
#include "engine/remesh/attempt.h"
#include "engine/remesh/steps.h"

namespace remeshd {

/// The local last resort, where a mesh is not valid: the places where it is wrong are refilled,
/// then with smaller facets where it is wrong again, and with more and more round them. A mesh that
/// took too many nodes and is wrong all over all the same is left alone.
///
/// Post: `candidate` is valid, with a warning in `attempt` and the share of the tets that were made
/// anew; or it is still wrong, and `attempt` has what was tried. Throws PatchTooSmall, and what
/// `refill` throws.
void confine(Candidate& candidate, const MeshingTask& task, const MeshPatch& patch,
             const InsideTest& inside, Attempt& attempt);

}  // namespace remeshd
