#pragma once

#include <string>

#include "engine/revision/revision.h"

namespace remeshd {

/// What quality drift of later edits is measured against, of a revision's mesh.
QualityReference quality_reference(const Revision& revision);

/// Whether it is the chain's last regular mesh itself: one edit lets nothing drift.
bool is_regular(const Revision& revision);

/// Whether so much is lost against the last regular mesh that another may be worth its time: 0.005
/// of the mean volume-length, 0.01 where edges are not `even` (details that come and go move it
/// too); or a tenth of the nodes that the edge length lets one expect.
bool has_drifted(const QualityReference& now, const QualityReference& then, bool even);

/// `0.801 mean volume-length, 1.08 of the nodes expected`.
std::string describe(const QualityReference& reference);

}  // namespace remeshd
