#pragma once

#include <string>

#include "engine/revision/revision.h"

namespace remeshd {

/// The figures of a revision's mesh that quality drift of later edits is measured against.
QualityReference quality_reference(const Revision& revision);

/// Whether the chain's reference is this revision's own mesh, a regular one or one that no regular
/// mesh was better than: its first edit does not count as drift.
bool is_regular(const Revision& revision);

/// Whether so much is lost against the last regular mesh that another may be worth its time: 0.005
/// of the mean volume-length, 0.02 where the mesh is not `even` (details that come and go change it
/// too); or a tenth, either way, of the number of nodes that the edge length lets one expect, which
/// is measured of even meshes alone.
bool has_drifted(const QualityReference& now, const QualityReference& then, bool even);

/// `0.801 mean volume-length, 1.08 of the nodes expected`.
std::string describe(const QualityReference& reference);

}  // namespace remeshd
