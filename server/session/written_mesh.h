#pragma once

#include <string>

#include "server/session/archive.h"

namespace remeshd {

/// A mesh that is on the disk and that no transaction has entered yet.
struct Archive::Written {
  RevisionRecord record;
  std::string recipe;  ///< as `packed`
};

}  // namespace remeshd
