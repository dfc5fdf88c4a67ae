#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "server/tier/object_store.h"

namespace remeshd {

/// A circuit breaker before a store: after three failures in a row every call fails at once, for
/// `limits::kTierRest`; then one call tries the store, and all do again if it succeeds.
///
/// A look-up with less time than `limits::kTierAnswer` may time out although the store works: its
/// timeout does not count as a failure, and while it is the one that tries the store, other calls
/// may try it too.
class Breaker final : public ObjectStore {
 public:
  using Clock = std::chrono::steady_clock;
  /// `tell`: called with the reason when the store is left alone, and with an empty text when it
  /// answers again; must not call the breaker; may be empty. `now`: a clock for tests.
  explicit Breaker(std::unique_ptr<ObjectStore> store,
                   std::function<void(const std::string& why)> tell = {},
                   std::function<Clock::time_point()> now = &Clock::now);

  [[nodiscard]] bool has(const std::string& key, double within) override;
  [[nodiscard]] std::optional<std::string> get(const std::string& key,
                                               const std::stop_token& stop) override;
  void put(const std::string& key, const std::string& bytes) override;
  [[nodiscard]] std::optional<std::string> start_of(const std::string& key,
                                                    std::size_t bytes) override;
  void list(const std::string& prefix,
            const std::function<void(const ObjectInfo&)>& visit) override;
  void remove(const std::string& key) override;

 private:
  enum class Haste : std::uint8_t { None, Great };

  template <typename Work>
  auto tried(Work&& work, Haste haste = Haste::None);
  void begin(Haste haste);
  void note_success();
  void note_failure(const std::string& why);

  const std::unique_ptr<ObjectStore> store_;
  const std::function<void(const std::string&)> tell_;
  const std::function<Clock::time_point()> now_;
  std::mutex mutex_;               ///< guards what follows
  int failures_ = 0;               ///< in a row
  Clock::time_point closed_from_;  ///< the store is left alone until then
  std::string why_;
};

}  // namespace remeshd
