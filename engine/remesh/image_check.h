#pragma once

#include "engine/remesh/remesh.h"

namespace remeshd {

/// Looks at every index and count of a revision that was read: what uses it may rely on them.
///
/// Pre: its cells, master and delivery are filled in.
/// Throws Error(Internal), naming the array at fault.
void check_indices(const Revision& revision);

}  // namespace remeshd
