#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

#include "server/session/guarded.h"

namespace remeshd {

/// Does something on a thread of its own some time after it is asked to, once for all that asked
/// meanwhile. What it throws is dropped. Its end waits for what is under way.
class Background {
 public:
  /// An empty `work` starts no thread.
  explicit Background(std::function<void()> work) : work_(std::move(work)) {
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
    for (;;) {
      {
        std::unique_lock lock(mutex_);
        if (!changed_.wait(lock, stop, [&] { return asked_; })) return;
        asked_ = false;
      }
      contained([&] { work_(); });
    }
  }

  const std::function<void()> work_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  bool asked_ = false;
  std::jthread thread_;
};

}  // namespace remeshd
