#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

#include "server/session/guarded.h"

namespace remeshd {

/// Does something on a thread of its own some time after it is asked to, once for all that asked
/// meanwhile; again a second later for as long as it returns true or throws. Its end waits for what
/// is under way.
class Background {
 public:
  /// An empty `work` starts no thread.
  explicit Background(std::function<bool()> work) : work_(std::move(work)) {
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
        if (again) {
          changed_.wait_for(lock, stop, std::chrono::seconds(1), asked);
        } else {
          changed_.wait(lock, stop, asked);
        }
        if (stop.stop_requested()) return;
        asked_ = false;
      }
      again = true;
      contained([&] { again = work_(); });
    }
  }

  const std::function<bool()> work_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  bool asked_ = false;
  std::jthread thread_;
};

}  // namespace remeshd
