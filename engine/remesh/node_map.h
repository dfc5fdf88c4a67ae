#pragma once

#include <span>

#include "engine/remesh/remesh.h"
#include "engine/verify/inheritance.h"

namespace remeshd {

/// Where the nodes and tets of a mesh come from that is all new.
NodeMap map_to_nothing(const TetMesh& mesh);

/// The same for the original's own tets over nodes that may have moved.
NodeMap map_kept(const Revision& original, std::span<const Vec3> nodes);

/// The original's mesh as one that was verified when it was made. `node`, `tet`: of another mesh,
/// which of the original's each may be.
VerifiedParent verified_parent(const Revision& original, std::span<const std::int32_t> node,
                               std::span<const std::int32_t> tet);

}  // namespace remeshd
