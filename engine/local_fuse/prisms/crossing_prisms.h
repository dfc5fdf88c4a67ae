#pragma once

#include "engine/local_fuse/prisms/parallel_prisms.h"

namespace remeshd {

/// The boundary of features each of which is swept along a direction of its own, in the form in
/// which fuse_parallel_prisms gives that of features with a common direction. It is made from the
/// curves in which planes cut each other and round walls (lines, circles and ellipses), and from
/// which features lie round these curves.
///
/// Gives up where a feature is not swept, there are too many, round walls cross whose axes are not
/// parallel, or anything comes so near to something else that it is not clear whether they meet.
///
/// Pre: the membership is the model's; features ascend.
Tried<FusedPrisms> fuse_crossing_prisms(const FeatureModel& model, const Membership& membership,
                                        std::span<const int> features, const FuseFrame& frame);

}  // namespace remeshd
