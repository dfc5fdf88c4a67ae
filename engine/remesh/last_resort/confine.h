#pragma once

#include "engine/patch/candidate.h"
#include "engine/patch/patch.h"
#include "engine/remesh/attempt.h"
#include "engine/remesh/steps.h"

namespace remeshd {

/// The local last resort, where a mesh is not valid: what is wrong is refilled, with smaller facets
/// where it is wrong again, and more and more round it. A mesh that is wrong all over, many nodes
/// inserted or not, stays as it is.
///
/// Post: `candidate` is valid, with a warning in `attempt` and the share of the tets that were made
/// anew; or it is wrong still, and `attempt` has what was tried.
void confine(Candidate& candidate, const MeshingTask& task, const MeshPatch& patch,
             const InsideTest& inside, Attempt& attempt);

}  // namespace remeshd
