#pragma once

#include "engine/base/run.h"

namespace remeshd::test {

/// A run that nobody watches and nothing limits. GoogleTest's fixtures have a `Run` of their own.
inline const remeshd::Run kRun;

}  // namespace remeshd::test
