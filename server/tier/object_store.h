#pragma once

#include <optional>
#include <string>

namespace remeshd {

/// Objects by key that several daemons share: a folder or a service over HTTP. Whoever writes an
/// object last is right. For any thread.
///
/// All functions throw Error(TIER_UNAVAILABLE) where the store cannot be reached, does not answer
/// in time, or fails: that never means that there is no object.
class ObjectStore {
 public:
  ObjectStore() = default;
  virtual ~ObjectStore() = default;
  ObjectStore(const ObjectStore&) = delete;
  ObjectStore& operator=(const ObjectStore&) = delete;

  /// Whether there is an object, told within so many seconds.
  [[nodiscard]] virtual bool has(const std::string& key, double within) = 0;
  /// Nothing where there is none.
  [[nodiscard]] virtual std::optional<std::string> get(const std::string& key) = 0;
  /// Returns when the store has it.
  virtual void put(const std::string& key, const std::string& bytes) = 0;
};

}  // namespace remeshd
