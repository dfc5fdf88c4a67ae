#pragma once

#include <string>

#include "server/session/archive.h"

namespace remeshd {

/// A mesh that is on the disk (unless `record.bytes` is 0) and that no transaction has entered yet.
struct Archive::Written {
  RevisionRecord record;
  std::string recipe;  ///< as `packed`
};

}  // namespace remeshd
