#pragma once

#include <string>

#include "engine/revision/revision.h"

namespace remeshd {

/// The figures of a revision's mesh that quality drift of later edits is measured against.
QualityReference quality_reference(const Revision& revision);

/// Whether the chain's reference is this revision's own mesh, a regular one or one that no regular
/// mesh was better than: its first edit does not count as drift.
bool is_regular(const Revision& revision);

/// Whether a mesh has become so much worse than the last regular mesh of its chain that a new
/// regular one may be worth its time. `now`: figures of the mesh; `then`: figures of the last
/// regular mesh.
///
/// True where the mean volume-length measure has fallen by more than 0.005, or by more than 0.04
/// where the mesh is not `even` (details that come and go change it too). True also where the
/// number of nodes, over the number expected for the edge length, has changed by more than 10%, up
/// or down; that is known for even meshes alone.
bool has_drifted(const QualityReference& now, const QualityReference& then, bool even);

/// `0.801 mean volume-length, 1.08 of the nodes expected`.
std::string describe(const QualityReference& reference);

}  // namespace remeshd
