#pragma once

#include <cstdint>

namespace remeshd {

/// Bytes of this process that are in memory now; 0 where the system does not tell.
std::uint64_t resident_bytes();
/// Has malloc keep a heap a processor (it would keep 8) for the threads to share, before there are
/// any: it gives nothing back of the end of a heap but of the first, and by and by each has been as
/// large as a computation needs.
void keep_few_heaps();
/// Gives memory that was freed back to the system, as far as whole pages of it are free.
void return_freed_memory();

}  // namespace remeshd
