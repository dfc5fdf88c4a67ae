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
#include "server/session/make_request.h"
#include "server/session/preparation.h"

namespace remeshd {

/// A revision being made, and those who wait for it.
struct Computation {
  Prepared prepared;
  std::stop_source stop;
  WorkId work = 0;
  std::vector<WaitingRequestPtr> waiting;  ///< guarded by the computations' mutex
};
using ComputationPtr = std::shared_ptr<Computation>;

/// The computations that wait for a worker or are under way.
///
/// Inv: for each id there is at most one that somebody waits for.
class Computations {
 public:
  /// Callbacks: `compute` on a worker's thread, `failed` on any, `is_made` under the mutex.
  struct Tasks {
    std::function<void(const ComputationPtr&)> compute;
    std::function<void(const ComputationPtr&, const Error&)> failed;
    /// Whether a revision has been made by now.
    std::function<bool(const std::string& id)> is_made;
  };
  enum class Entry {
    Waits,     ///< for a computation, its own or that of another request
    IsMade,    ///< the revision is there
    Answered,  ///< the request was cancelled
  };

  /// The lane must outlive it.
  Computations(Pool& lane, Tasks tasks) : lane_(lane), tasks_(std::move(tasks)) {}

  /// Has a request wait for its revision, which is computed if it is not yet. Throws what
  /// Pool::submit throws.
  Entry enter(const WaitingRequestPtr& request, const Prepared& prepared);
  /// The request waits no more. A computation that nobody waits for is stopped.
  void leave(const WaitingRequestPtr& request);
  /// Takes a computation off the list; returns who waited for it.
  std::vector<WaitingRequestPtr> remove(const ComputationPtr& computation);
  /// Those who wait for it now.
  [[nodiscard]] std::vector<WaitingRequestPtr> waiting_for(const ComputationPtr& computation) const;

  /// Requests that wait.
  [[nodiscard]] std::size_t waiting() const;

 private:
  void erase(const ComputationPtr& computation);

  Pool& lane_;
  const Tasks tasks_;
  mutable std::mutex mutex_;
  std::map<std::string, ComputationPtr> by_id_;
};

}  // namespace remeshd
