#pragma once

#include <chrono>
#include <cstdint>

namespace remeshd {

/// ns since 1970, UTC.
inline std::int64_t nanoseconds_now() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

}  // namespace remeshd
