#pragma once

#include <string>

#include "tests/bench/results.h"

namespace remeshd::bench {

/// Meshes sized by the rules beside the peers': numbers of nodes, time, quality, edges of circles.
/// Empty where no run was sized.
std::string sized_table(const Results& results);

}  // namespace remeshd::bench
