#pragma once

#include "server/service/front_desk.h"
#include "server/session/commands.h"

namespace remeshd {

/// Counts what a command made, where it was made for it.
void count_made(const FrontDesk& desk, const Made& made);

}  // namespace remeshd
