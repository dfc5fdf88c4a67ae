#pragma once

#include "server/service/front_desk.h"
#include "server/session/commands.h"

namespace remeshd {

/// Counts in the metrics the revision that a command made, unless it existed already.
void count_made(const FrontDesk& desk, const Made& made);

}  // namespace remeshd
