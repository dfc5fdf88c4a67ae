#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "server/session/resources.h"
#include "server/session/session.h"
#include "server/store/store.h"

namespace remeshd {

/// The tenants of a daemon. Each has a session of its own over a store of its own, so that nothing
/// of one can be named by another; engine, lanes and budgets they share. The tenant `` is that of a
/// daemon that asks for no tokens. For any thread.
///
/// Inv: a session that was opened stays until the end.
class Tenants {
 public:
  using OpenStore = std::function<std::unique_ptr<Store>(const std::string& tenant)>;

  /// Opens the session of the tenant ``. Throws what `open_store` throws. `metrics`: counts queues,
  /// requests of the cache and evictions; null for none. `sharing`: as of Session.
  Tenants(Engine engine, SessionLimits limits, OpenStore open_store,
          std::shared_ptr<Metrics> metrics = nullptr, Sharing sharing = {});
  /// As `stop`.
  ~Tenants();
  Tenants(const Tenants&) = delete;
  Tenants& operator=(const Tenants&) = delete;

  /// Opens the session of a tenant, unless it is open; waits for the disk. Throws what `open_store`
  /// throws, Error(SHUTTING_DOWN).
  void open(const std::string& tenant);
  /// Never waits for the disk. Throws std::out_of_range for a tenant whose session is not open.
  Session& of(const std::string& tenant);

  /// The load of all tenants together.
  [[nodiscard]] Load load();
  /// How much work waits for a lane.
  [[nodiscard]] std::size_t queued(Lane lane) { return resources_.lane(lane).queued(); }
  [[nodiscard]] const SessionLimits& limits() const { return resources_.limits(); }
  [[nodiscard]] bool persistent() { return of("").persistent(); }
  /// Called with the tenants whose stores cannot be written to.
  using HealthListener = std::function<void(const std::set<std::string>& unhealthy)>;
  /// Calls `listener` with them now and at every change. It must not call back; empty: nobody.
  void on_store_health(HealthListener listener);
  /// As MemoryBudget::on_full.
  void on_memory_full(std::function<void(bool full)> listener) {
    resources_.memory().on_full(std::move(listener));
  }

  /// Answers whatever is under way with Unavailable, and returns when every thread has come to
  /// rest. No session is opened any more.
  void stop();

 private:
  std::vector<Session*> sessions();
  void note_health(const std::string& tenant, bool healthy);

  const OpenStore open_store_;
  const Sharing sharing_;
  std::mutex health_;                ///< guards what follows
  std::set<std::string> unhealthy_;  ///< tenants
  HealthListener health_listener_;
  Resources resources_;
  std::mutex opening_;  ///< held while a session is opened
  std::mutex mutex_;    ///< guards what follows
  bool stopped_ = false;
  std::map<std::string, std::unique_ptr<Session>> sessions_;  ///< by tenant
};

}  // namespace remeshd
