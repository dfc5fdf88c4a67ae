#pragma once

#include "engine/base/run.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// A model as the base of edits before it has a mesh: its cells, the names of faces that its mesh
/// will have, and its groups with their exact areas. Edits of it can be validated, not meshed. It
/// has no density: as `Revision::none()`.
///
/// Throws what `build_cells` does.
Revision unmeshed(const FeatureModel& model, const Run& run);

}  // namespace remeshd
