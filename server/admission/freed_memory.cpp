#include "server/admission/freed_memory.h"

#include <utility>

#include "server/limits.h"

namespace remeshd {

FreedMemory::FreedMemory(MemoryBudget::Process process, std::function<void()> also)
    : process_(std::move(process)),
      also_(std::move(also)),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

void FreedMemory::look() {
  if (process_.resident() < resident_ + limits::kReturnGrowth) return;
  process_.return_freed_memory();
  resident_ = process_.resident();
}

void FreedMemory::run(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stopping_.wait_for(lock, stop, limits::kReturnInterval, [] { return false; }) &&
         !stop.stop_requested()) {
    look();
    also_();
  }
}

}  // namespace remeshd
