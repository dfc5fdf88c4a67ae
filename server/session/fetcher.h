#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <vector>

#include "server/admission/pool.h"
#include "server/session/archive.h"

namespace remeshd {

/// Gets revisions for work in the lane of preparations, whose few threads must neither compute nor
/// wait for a computation: loads of all tenants would wait behind it. A revision that is in memory
/// or can be loaded is handed over at once. A mesh that must be made again of its recipe is made in
/// the lane of computations, under its queue, its fair shares and its time limit, and handed over
/// in the lane of preparations afterwards. Those who want the same mesh share one computation.
class Fetcher {
 public:
  /// Exactly one of these is called, once; but where `got` throws, `failed` is called with that.
  struct Receiver {
    std::function<void(const HeldRevisionPtr&)> got;  ///< called in the lane of preparations
    std::function<void(const Error&)> failed;         ///< called by any thread; must not block
  };
  /// What it works with; must outlive it.
  struct Parts {
    Archive& archive;
    Pool& preparation;
    Pool& computation;
  };

  Fetcher(std::string tenant, Parts parts) : tenant_(std::move(tenant)), parts_(parts) {}
  /// As `stop`.
  ~Fetcher() { stop(); }
  Fetcher(const Fetcher&) = delete;
  Fetcher& operator=(const Fetcher&) = delete;

  /// To be called in the lane of preparations; either function may be called before this returns.
  /// Who waits for a computation hears Cancelled as soon as `stop` is requested; a computation that
  /// nobody waits for any more is stopped. Never throws: `failed` hears what Archive::get and
  /// Pool::submit throw, WAITED_TOO_LONG and COMPUTE_LIMIT_REACHED.
  void fetch(const std::string& id, const std::stop_token& stop, const Receiver& receiver);

  /// Ends every wait with Unavailable and asks the computations to stop.
  void stop();

  /// Receivers that wait for a computation.
  [[nodiscard]] std::size_t waiting() const;

 private:
  struct Remake;
  struct Waiter;
  using RemakePtr = std::shared_ptr<Remake>;
  using WaiterPtr = std::shared_ptr<Waiter>;

  void wait_for_remake(const std::string& id, const std::stop_token& stop,
                       const Receiver& receiver);
  void start(const RemakePtr& remake);
  void compute(const RemakePtr& remake);
  void fail(const RemakePtr& remake, const Error& why);
  void hand_over(const Receiver& receiver, const HeldRevisionPtr& revision);
  void leave(const WaiterPtr& waiter);
  /// Takes a computation off the list; returns who waited for it.
  std::vector<WaiterPtr> remove(const RemakePtr& remake);

  const std::string tenant_;
  const Parts parts_;
  mutable std::mutex mutex_;
  bool stopped_ = false;
  std::map<std::string, RemakePtr> by_id_;  ///< those that somebody waits for
};

}  // namespace remeshd
