#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

#include "server/admission/memory_budget.h"

namespace remeshd {

/// Returns freed memory to the system now and then: fragmentation makes malloc keep much of what a
/// computation frees, and more from hour to hour.
class FreedMemory {
 public:
  /// Starts a thread that calls `look`, then `also`, every `limits::kReturnInterval`.
  explicit FreedMemory(
      MemoryBudget::Process process, std::function<void()> also = [] {});

  /// Returns freed memory if the process has grown by `limits::kReturnGrowth` since the last time,
  /// so that nothing is done to an idle daemon.
  void look();

 private:
  void run(const std::stop_token& stop);

  const MemoryBudget::Process process_;
  const std::function<void()> also_;
  std::uint64_t resident_ = 0;  ///< bytes, after memory was last returned
  std::mutex mutex_;
  std::condition_variable_any stopping_;
  std::jthread thread_;  ///< last: it uses what stands before it
};

}  // namespace remeshd
