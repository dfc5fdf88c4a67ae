#pragma once

#include "engine/base/stored_array.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// Everything in a Revision that cannot be recomputed quickly, as arrays by name and type. Equal
/// revisions give equal bytes: all seconds of the report, `report.revision` and `report.cached`
/// stay out. The arrays refer to memory of the revision, which has to outlive them.
StoredArrays image_of(const Revision& revision);

/// Restores a revision, and its boundary to the bit; also from the older format, `kOlderBytes`.
/// `alike`: a revision to share memory with where both are the same; null for none.
/// Throws Error(Internal) where arrays are missing, malformed or contradict each other: every index
/// is checked, so that no image makes the engine read beyond an array.
Revision revision_of(const StoredArrays& image, const Revision* alike, const Run& run);

}  // namespace remeshd
