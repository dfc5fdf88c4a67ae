#pragma once

#include "engine/base/stopwatch.h"
#include "engine/remesh/attempt.h"

namespace remeshd {

/// Makes the attempt that was taken the revision's mesh, with its maps, names and figures; renews
/// it where its quality has drifted along the chain of edits and a regular mesh is better.
/// `watch`: started when the revision was begun.
///
/// Throws Error(SELECTOR_EMPTY) where a group of a first mesh is empty, Error(POLICY_BROKEN).
void complete(Attempt taken, const Problem& problem, Revision& revision, Stopwatch& watch);

}  // namespace remeshd
