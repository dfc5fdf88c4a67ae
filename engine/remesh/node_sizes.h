#pragma once

#include <optional>

#include "engine/base/run.h"
#include "engine/plan/copy_plan.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// By output node of a revision the edge length that it was made for. All nodes have the parent's
/// where the parent's tets were kept. Else a node that was kept has the parent's, unless that
/// differs much from the size field and a change may be why; all others have that of the size
/// field. Empty for an even mesh.
/// @param plan  that the mesh was made by; null where the tets of the parent were kept
CowVector<double> made_for(const Revision& parent, const Revision& revision, const CopyPlan* plan,
                           const Run& run);

struct Resized {
  CopyPlan plan;
  double most_off;  ///< greatest ratio of the length that a node was made for and the one wanted
};

/// The plan, but material that would be copied is new round nodes that were made for an edge length
/// more than a quarter off the one wanted now where they would be copied to, if a change may be
/// why. Round such a node means that no other node of the parent is nearer. Nothing where there are
/// no such nodes, as where both meshes are even.
std::optional<Resized> resized(const CopyPlan& plan, const Revision& parent, const Revision& wanted,
                               const SizeField& sizes, const Run& run);

}  // namespace remeshd
