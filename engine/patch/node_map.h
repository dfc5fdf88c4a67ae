#pragma once

#include "engine/revision/revision.h"
#include "engine/verify/inheritance.h"

namespace remeshd {

/// Where the nodes and tets of a mesh come from where every one has the original's number, and
/// nodes may have moved; but for the transformations. `identity`: which of them is none.
NodeMap map_to_itself(const Revision& original, const CowVector<Vec3>& nodes,
                      std::int32_t identity);

/// The same for the original's own tets, with the one transformation that there is then.
NodeMap map_kept(const Revision& original, const CowVector<Vec3>& nodes);

/// The original's mesh as one that was verified when it was made. `node`, `tet`: of another mesh,
/// which of the original's each may be.
VerifiedParent verified_parent(const Revision& original, const CowVector<std::int32_t>& node,
                               const CowVector<std::int32_t>& tet);
/// The same of a mesh that has all nodes and tets of the original under their numbers.
VerifiedParent verified_parent(const Revision& original);

}  // namespace remeshd
