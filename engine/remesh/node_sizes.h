#pragma once

#include <vector>

#include "engine/base/region.h"
#include "engine/base/run.h"
#include "engine/plan/copy_plan.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// By output node of a revision the edge length that it was made for: that of its size field where
/// the node is new or has moved, the parent's where it has stayed. None of an even mesh.
CowVector<double> made_for(const Revision& parent, const Revision& revision, const Run& run);

/// Where nodes that would stay in place were made for edge lengths that differ from those wanted
/// now by more than a quarter, with their own surroundings. Empty where both meshes are even.
std::vector<Region> resized_places(const Revision& parent, const Revision& wanted,
                                   const SizeField& sizes, const CopyPlan& plan, const Run& run);

}  // namespace remeshd
