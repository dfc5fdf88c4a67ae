#pragma once

#include "engine/remesh/stages.h"

namespace remeshd {

/// Turns a verified candidate into what is delivered and what the next edit starts from: node and
/// tet maps, permanent ids, groups, master; and counts what was kept.
void deliver(Candidate candidate, const Revision* original, const PointSource& source,
             Revision& revision, const Run& run);

/// Counts nodes and tets by origin and measures the delivered mesh, into `revision.report`.
void account(Revision& revision);

}  // namespace remeshd
