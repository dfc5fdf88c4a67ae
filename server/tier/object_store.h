#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>

namespace remeshd {

/// What a store tells of an object without giving it.
struct ObjectInfo {
  std::string key;
  std::uint64_t bytes = 0;
  std::int64_t written_ns = 0;  ///< since 1970, UTC
};

/// Objects by key that several daemons share: a folder or a service over HTTP. The last write of an
/// object wins. For any thread.
///
/// All functions throw Error(TIER_UNAVAILABLE) where the store cannot be reached, does not answer
/// in time, or fails: that never means that there is no object.
class ObjectStore {
 public:
  ObjectStore() = default;
  virtual ~ObjectStore() = default;
  ObjectStore(const ObjectStore&) = delete;
  ObjectStore& operator=(const ObjectStore&) = delete;

  /// Whether there is an object. `within`: s until an answer or an Error, where the store can limit
  /// that.
  [[nodiscard]] virtual bool has(const std::string& key, double within) = 0;
  /// Nothing where there is none. Throws Error(Cancelled) where `stop` is requested before all of
  /// it is here, as far as the store can be left in between.
  [[nodiscard]] virtual std::optional<std::string> get(const std::string& key,
                                                       const std::stop_token& stop) = 0;
  /// Returns when the store has it. Throws Error(TIER_REFUSED) too, for an object that is too large
  /// for it.
  virtual void put(const std::string& key, const std::string& bytes) = 0;

  // For pins and garbage collection only; making and reading revisions does without these.

  /// At least the first `bytes` bytes of an object, or all of a shorter one; nothing where there is
  /// no object.
  [[nodiscard]] virtual std::optional<std::string> start_of(const std::string& key,
                                                            std::size_t bytes) = 0;
  /// Calls `visit` with all objects whose keys begin with `prefix`, which ends with a slash.
  virtual void list(const std::string& prefix,
                    const std::function<void(const ObjectInfo&)>& visit) = 0;
  /// No error where there is none.
  virtual void remove(const std::string& key) = 0;
};

}  // namespace remeshd
