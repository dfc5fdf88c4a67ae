#pragma once

#include "engine/base/stored_array.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// Everything in a Revision that cannot be recomputed from its documents at once, as arrays by name
/// and type. Equal revisions give equal bytes: `report.seconds`, `report.revision` and
/// `report.cached` stay out. The arrays lie in the revision, which has to outlive them.
StoredArrays image_of(const Revision& revision);

/// Restores a revision, and its boundary to the bit; also from `kOlderBytes`. `alike`: one that is
/// to share the memory of what is the same; null for none.
/// Throws Error(Internal) where arrays are missing, malformed or contradict each other: every index
/// is looked at, so that no image makes the engine read beyond an array.
Revision revision_of(const StoredArrays& image, const Revision* alike, const Run& run);

}  // namespace remeshd
