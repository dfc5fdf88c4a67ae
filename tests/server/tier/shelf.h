#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "server/tier/object_store.h"
#include "server/tier/tier_error.h"

namespace remeshd::test {

/// Objects in memory, of a store that can fail.
class Shelf final : public ObjectStore {
 public:
  [[nodiscard]] bool has(const std::string& key, double /*within*/) override {
    check();
    const std::scoped_lock lock(mutex_);
    return objects_.contains(key);
  }
  [[nodiscard]] std::optional<std::string> get(const std::string& key,
                                               const std::stop_token& stop) override {
    check();
    while (get_hangs) {
      if (stop.stop_requested()) throw error::cancelled();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    const std::scoped_lock lock(mutex_);
    const auto found = objects_.find(key);
    if (found == objects_.end()) return std::nullopt;
    return found->second;
  }
  void put(const std::string& key, const std::string& bytes) override {
    check();
    if (before_put) before_put(key);
    const std::scoped_lock lock(mutex_);
    objects_[key] = bytes;
    written_[key] =
        std::chrono::nanoseconds(std::chrono::system_clock::now().time_since_epoch()).count();
  }
  /// Makes all objects older.
  void age(double seconds) {
    const std::scoped_lock lock(mutex_);
    for (auto& [key, written] : written_) written -= static_cast<std::int64_t>(1e9 * seconds);
  }

  [[nodiscard]] std::optional<std::string> start_of(const std::string& key,
                                                    std::size_t bytes) override {
    auto object = get(key, {});
    if (object) object->resize(std::min(object->size(), bytes));
    return object;
  }
  void list(const std::string& prefix,
            const std::function<void(const ObjectInfo&)>& visit) override {
    for (const std::string& key : keys(prefix)) {
      const std::scoped_lock lock(mutex_);
      visit({.key = key, .bytes = objects_[key].size(), .written_ns = written_[key]});
    }
  }
  void remove(const std::string& key) override {
    check();
    const std::scoped_lock lock(mutex_);
    if (before_remove) before_remove(key);
    objects_.erase(key);
  }
  /// Keys that contain a text, sorted.
  [[nodiscard]] std::vector<std::string> keys(const std::string& part = "") const {
    const std::scoped_lock lock(mutex_);
    std::vector<std::string> keys;
    for (const auto& [key, bytes] : objects_)
      if (key.find(part) != std::string::npos) keys.push_back(key);
    return keys;
  }

  std::atomic<bool> fails = false;
  std::atomic<bool> times_out = false;
  std::atomic<bool> get_hangs = false;  ///< until that is cancelled
  std::atomic<int> asked = 0;
  std::function<void(const std::string&key)> before_put, before_remove;  ///< may be empty

 private:
  void check() {
    ++asked;
    if (fails) throw error::tier_unavailable("it is out", 10);
    if (times_out) throw error::tier_timed_out("it is slow", 10);
  }

  mutable std::mutex mutex_;
  std::map<std::string, std::string> objects_;
  std::map<std::string, std::int64_t> written_;  ///< ns since 1970
};

}  // namespace remeshd::test
