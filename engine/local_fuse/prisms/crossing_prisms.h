#pragma once

#include "engine/local_fuse/prisms/parallel_prisms.h"

namespace remeshd {

/// The boundary of features each of which is swept along a direction of its own, as
/// fuse_parallel_prisms gives it of those that are swept along one: from the curves in which planes
/// cut each other and round walls, lines, circles and ellipses, and from which features lie round
/// these curves.
///
/// Gives up where they are no such features, or round walls cross whose axes are not
/// parallel, or anything comes so near to something else that it is not clear whether they meet.
///
/// Pre: the membership is the model's; features ascend.
Tried<FusedPrisms> fuse_prisms(const FeatureModel& model, const Membership& membership,
                               std::span<const int> features, const FuseFrame& frame);

}  // namespace remeshd
