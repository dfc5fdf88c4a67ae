#pragma once

#include <string>

#include "engine/base/run.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// Values of a parameter for which an edit of a revision keeps its connectivity.
struct Horizon {
  double value = 0;  ///< in the model
  double lower = 0, upper = 0;
  std::string lower_reason, upper_reason;  ///< what changes beyond, in words
};

/// How far a parameter may go, alone, before the connectivity changes. `hold`: as in MeshOptions, x
/// edge length; 0: where morphing gives up. Every value tried is meshed as an edit would be, up to
/// its verification; the ends are found to a hundredth of the way searched.
///
/// Throws what `change_of` throws.
Horizon connectivity_horizon(const Revision& revision, const std::string& parameter, double hold,
                             const Run& run);

}  // namespace remeshd
