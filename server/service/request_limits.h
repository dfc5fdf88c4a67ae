#pragma once

#include <cstddef>

#include "proto/json_reader.h"
#include "server/limits.h"

namespace remeshd {

/// What a request may be at most.
struct RequestLimits {
  std::size_t message_bytes = limits::kRequestBytes;
  DocumentLimits document;  ///< of a model or edit that comes as text
};

}  // namespace remeshd
