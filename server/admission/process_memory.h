#pragma once

#include <cstdint>

namespace remeshd {

/// Bytes of this process that are in memory now; 0 where the system does not tell.
std::uint64_t resident_bytes();
/// Gives memory that was freed back to the system, as far as whole pages of it are free.
void return_freed_memory();

}  // namespace remeshd
