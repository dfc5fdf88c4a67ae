#pragma once

#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <string>
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
  [[nodiscard]] std::optional<std::string> get(const std::string& key) override {
    check();
    const std::scoped_lock lock(mutex_);
    const auto found = objects_.find(key);
    if (found == objects_.end()) return std::nullopt;
    return found->second;
  }
  void put(const std::string& key, const std::string& bytes) override {
    check();
    const std::scoped_lock lock(mutex_);
    objects_[key] = bytes;
  }

  void remove(const std::string& key) {
    const std::scoped_lock lock(mutex_);
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
  std::atomic<int> asked = 0;

 private:
  void check() {
    ++asked;
    if (fails) throw error::tier_unavailable("it is out", 10);
  }

  mutable std::mutex mutex_;
  std::map<std::string, std::string> objects_;
};

}  // namespace remeshd::test
