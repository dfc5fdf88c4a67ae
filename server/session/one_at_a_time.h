#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <string>
#include <utility>

#include "engine/base/run.h"

namespace remeshd {

/// Lets one thread at a time do something for a name; others for the same name wait.
class OneAtATime {
 public:
  class Turn {
   public:
    Turn(OneAtATime& owner, std::string name) : owner_(&owner), name_(std::move(name)) {}
    ~Turn() {
      if (owner_ == nullptr) return;
      const std::scoped_lock lock(owner_->mutex_);
      owner_->taken_.erase(name_);
      owner_->freed_.notify_all();
    }
    Turn(Turn&& other) noexcept
        : owner_(std::exchange(other.owner_, nullptr)), name_(std::move(other.name_)) {}
    Turn& operator=(Turn&&) = delete;

   private:
    OneAtATime* owner_;
    std::string name_;
  };

  /// Waits for the turn, which lasts as long as what is returned.
  /// Throws Error(Cancelled) within 100 ms of a stop request.
  [[nodiscard]] Turn take(const std::string& name, const Run& run = {}) {
    std::unique_lock lock(mutex_);
    while (!taken_.insert(name).second) {
      freed_.wait_for(lock, std::chrono::milliseconds(50));
      run.poll();
    }
    return Turn(*this, name);
  }

 private:
  std::mutex mutex_;
  std::condition_variable freed_;
  std::set<std::string> taken_;
};

}  // namespace remeshd
