#pragma once

#include <string>

#include "server/session/clock.h"
#include "server/store/records.h"

namespace remeshd {

/// The operation that notes that a design's head or list changes now.
inline AddDesign changed_now(const std::string& design) {
  return {.name = design, .changed_ns = nanoseconds_now()};
}

}  // namespace remeshd
