#include "server/admission/process_memory.h"

#include <malloc.h>
#include <unistd.h>

#include <fstream>

namespace remeshd {

std::uint64_t resident_bytes() {
  std::ifstream in("/proc/self/statm");
  std::uint64_t size = 0, resident = 0;
  if (!(in >> size >> resident)) return 0;
  return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void return_freed_memory() { ::malloc_trim(0); }

}  // namespace remeshd
