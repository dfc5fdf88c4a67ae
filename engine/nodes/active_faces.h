#pragma once

#include "engine/nodes/node_set.h"
#include "engine/plan/copy_plan.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

/// Frees the nodes in the vicinity of active faces (Sect. 7): faces between copies of different
/// origin, and faces that are boundary in one of the models only. All faces of the modified
/// features are looked at, and those of the original features wherever a copy carries them along.
/// Regularly spaced points on each free their nearest node.
///
/// The points are half an edge length apart.
void free_at_active_faces(CopiedNodes& nodes, const CopyPlan& plan, const SizeField& sizes,
                          const Run& run);

}  // namespace remeshd
