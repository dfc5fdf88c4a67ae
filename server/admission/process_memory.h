#pragma once

#include <cstdint>

namespace remeshd {

/// Bytes of this process that are in memory now; 0 where the system does not tell.
std::uint64_t resident_bytes();
/// Limits malloc to one arena a processor, and four at least, for all threads (the default is 8 a
/// processor). To be called before threads are started. malloc gives back the end of the first
/// arena only, and in time each of them has grown as large as a computation needs.
void keep_few_heaps();
/// Gives memory that was freed back to the system, as far as whole pages of it are free.
void return_freed_memory();

}  // namespace remeshd
