#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/base/error.h"

/// Refusals for want of room, of time or of a daemon that goes on.
namespace remeshd::error {

/// `retry_after` in s.
Error busy(std::size_t waiting, double retry_after);
Error waited_too_long(double seconds, double retry_after);
/// It computed for longer than the daemon allows, in s.
Error compute_limit_reached(double seconds);
/// All of the budget is in use; in bytes.
Error memory_full(std::uint64_t used, std::uint64_t budget, double retry_after = 0);
/// What would take more bytes than there are in all, so that waiting does not help.
Error never_fits(std::uint64_t bytes, std::uint64_t budget);
Error out_of_memory();
Error shutting_down();

}  // namespace remeshd::error
