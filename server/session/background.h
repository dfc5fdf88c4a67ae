#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

#include "server/session/catching.h"

namespace remeshd {

/// Calls `work` on a thread of its own after `ask`, once for all calls of `ask` meanwhile; again a
/// second later for as long as it returns true or throws. The destructor waits for a call under
/// way.
class Background {
 public:
  enum class Begin { Soon, AfterASecond };
  /// An empty `work` starts no thread.
  explicit Background(std::function<bool()> work, Begin begin = Begin::Soon)
      : work_(std::move(work)), begin_(begin) {
    if (work_) thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  }

  void ask() {
    if (!work_) return;
    const std::scoped_lock lock(mutex_);
    asked_ = true;
    changed_.notify_all();
  }

 private:
  void run(const std::stop_token& stop) {
    bool again = false;
    for (;;) {
      {
        std::unique_lock lock(mutex_);
        const auto asked = [&] { return asked_; };
        const auto hurried = [&] { return asked_ && begin_ == Begin::Soon; };
        if (!again) changed_.wait(lock, stop, asked);
        if (again || begin_ == Begin::AfterASecond)
          changed_.wait_for(lock, stop, std::chrono::seconds(1), hurried);
        if (stop.stop_requested()) return;
        asked_ = false;
      }
      again = true;
      contained([&] { again = work_(); });
    }
  }

  const std::function<bool()> work_;
  const Begin begin_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  bool asked_ = false;
  std::jthread thread_;
};

}  // namespace remeshd
