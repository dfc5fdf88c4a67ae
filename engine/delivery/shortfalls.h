#pragma once

#include <vector>

#include "engine/base/warning.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// Where a valid mesh falls short of what was aimed at, by the figures of its report: its number of
/// nodes, its least quality, the chords across curved faces, mid-nodes left on straight edges.
std::vector<Warning> shortfalls(const Revision& made);

}  // namespace remeshd
