#pragma once

#include "server/session/session.h"

namespace remeshd::fuzz {

/// A session in memory with the tests' quick engine and a design `plate` of two revisions. Made at
/// the first call, and the same from then on: what changes it would make runs depend on each other.
Session& quiet_session();

}  // namespace remeshd::fuzz
