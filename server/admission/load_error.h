#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/base/error.h"

/// Errors of a daemon that is short of room or time, or that is ending.
namespace remeshd::error {

/// `retry_after` in s.
Error busy(std::size_t waiting, double retry_after);
Error waited_too_long(double seconds, double retry_after);
/// The request computed for longer than the `seconds` that the daemon allows.
Error compute_limit_reached(double seconds);
/// There is no room in the memory budget; in bytes.
Error memory_full(std::uint64_t used, std::uint64_t budget, double retry_after = 0);
/// The request needs more bytes than the whole budget has, so that waiting does not help.
Error never_fits(std::uint64_t bytes, std::uint64_t budget);
Error out_of_memory();
Error shutting_down();

}  // namespace remeshd::error
