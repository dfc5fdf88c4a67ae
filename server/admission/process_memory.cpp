#include "server/admission/process_memory.h"

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <thread>

namespace remeshd {
namespace {

// With as many arenas as workers, workers share theirs with the threads that answer calls, and two
// workers together get 3 % less done (`clients` in tests/service).
constexpr int kLeastHeaps = 4;

}  // namespace

std::uint64_t resident_bytes() {
  std::ifstream in("/proc/self/statm");
  std::uint64_t size = 0, resident = 0;
  if (!(in >> size >> resident)) return 0;
  return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void keep_few_heaps() {
  const int processors = static_cast<int>(std::thread::hardware_concurrency());
  ::mallopt(M_ARENA_MAX, std::max(kLeastHeaps, processors));
}

void return_freed_memory() { ::malloc_trim(0); }

}  // namespace remeshd
