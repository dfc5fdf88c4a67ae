#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

#include "server/admission/memory_budget.h"

namespace remeshd {

/// Gives memory that was freed back to the system now and then: malloc keeps much of what a
/// computation leaves, between what lives on, and more from hour to hour.
class FreedMemory {
 public:
  /// Looks on a thread of its own, every `limits::kReturnInterval`, and calls `also`.
  explicit FreedMemory(
      MemoryBudget::Process process, std::function<void()> also = [] {});

  /// Gives back where the process has grown by `limits::kReturnGrowth` since it last did; an idle
  /// daemon has nothing done to it.
  void look();

 private:
  void run(const std::stop_token& stop);

  const MemoryBudget::Process process_;
  const std::function<void()> also_;
  std::uint64_t resident_ = 0;  ///< once it last gave back
  std::mutex mutex_;
  std::condition_variable_any stopping_;
  std::jthread thread_;  ///< last: it uses what stands before it
};

}  // namespace remeshd
