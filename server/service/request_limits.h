#pragma once

#include <cstddef>

#include "proto/json_reader.h"

namespace remeshd {

/// What a request may be at most.
struct RequestLimits {
  std::size_t message_bytes = std::size_t{8} << 20;
  DocumentLimits document;  ///< of text in it
};

}  // namespace remeshd
