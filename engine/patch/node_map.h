#pragma once

#include "engine/revision/revision.h"
#include "engine/verify/inheritance.h"

namespace remeshd {

/// The NodeMap of a mesh all of whose nodes and tets have their numbers of the original, while
/// nodes may have moved. Its lists of transformations are left empty; `identity`: index of the
/// identity in them.
NodeMap map_to_itself(const Revision& original, const CowVector<Vec3>& nodes,
                      std::int32_t identity);

/// The same with the identity as its only transformation.
NodeMap map_kept(const Revision& original, const CowVector<Vec3>& nodes);

/// The original's mesh, which was verified when it was made, as the verified parent of another one.
/// `node`, `tet`: by node and tet of that, the original's that it claims to be, or -1.
VerifiedParent verified_parent(const Revision& original, const CowVector<std::int32_t>& node,
                               const CowVector<std::int32_t>& tet);
/// The same of a mesh that has all nodes and tets of the original under their numbers.
VerifiedParent verified_parent(const Revision& original);

}  // namespace remeshd
