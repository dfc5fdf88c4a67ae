#pragma once

#include <optional>

#include "engine/base/run.h"
#include "engine/plan/copy_plan.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// By output node of a revision the edge length that it was made for: that of its size field where
/// the node is new or has moved, or has stayed though that differs much from the parent's near a
/// change, else the parent's. None of an even mesh.
/// @param plan  that it was made by; null where the tets of the parent were kept
CowVector<double> made_for(const Revision& parent, const Revision& revision, const CopyPlan* plan,
                           const Run& run);

/// The plan with what would stay in place new round nodes that were made for edge lengths that
/// differ from those wanted now by more than a quarter, where a change may be why: where one of
/// them is the nearest node.
/// Nothing where there are none, as where both meshes are even.
std::optional<CopyPlan> resized(const CopyPlan& plan, const Revision& parent,
                                const Revision& wanted, const SizeField& sizes, const Run& run);

}  // namespace remeshd
