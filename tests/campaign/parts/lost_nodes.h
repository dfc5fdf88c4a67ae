#pragma once

#include "engine/revision/revision.h"

namespace remeshd::campaign {

/// Nodes of a base that are not in its edit's mesh as they were, or as the feature was moved that
/// they were copied with.
struct LostNodes {
  int all = 0;
  int far = 0;          ///< further than kFar local lengths of the base from what changed
  double furthest = 0;  ///< of the far ones, in local lengths; kNowhere where nothing changed
};
inline constexpr double kFar = 6;
inline constexpr double kNowhere = 1e6;

LostNodes lost_nodes(const Revision& base, const Revision& edited);

}  // namespace remeshd::campaign
