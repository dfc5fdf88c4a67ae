#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "server/admission/fair_queue.h"
#include "server/admission/jitter.h"

namespace remeshd {

/// A lane: a bounded number of threads before a bounded queue that is fair to tenants.
///
/// Inv: of each submitted work exactly one happens: it runs, it is refused, or it is withdrawn.
class Pool {
 public:
  struct Limits {
    int workers = 1;
    std::size_t queue = 64;  ///< work that may wait, beside what idle workers take
    double wait = 60;        ///< s; what waits longer is refused
    double compute = 0;      ///< s; for what runs longer `overdue` is called; 0: no limit
    /// How far its threads give way to others for a processor, as nice(1) counts.
    int niceness = 0;
    /// Called before each work runs, with the seconds that it waited; may be empty.
    std::function<void(double seconds)> waited{};
  };

  explicit Pool(Limits limits);
  /// As `shutdown`.
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  /// `refused` gets `WAITED_TOO_LONG` or `SHUTTING_DOWN`. What the functions throw is dropped:
  /// whoever waits for an answer has to be told by the work itself. Throws Error(`BUSY`) with a
  /// retry delay where the queue has no room, `SHUTTING_DOWN` after shutdown.
  WorkId submit(Work work);
  /// Takes it out of the queue; false if it is not there any more.
  bool withdraw(WorkId id);
  /// Refuses what waits and returns when what runs has ended. Not to be called by work.
  void shutdown();

  /// How much more a tenant could submit right now.
  [[nodiscard]] std::size_t room(const std::string& tenant);
  /// The refusal that `submit` would throw now. Its delay is the estimated time until there is
  /// room, with jitter (`Jitter`).
  [[nodiscard]] Error busy();
  /// Tells the pool how many seconds a piece of work took, from which retry delays are estimated.
  void took(double seconds);

  [[nodiscard]] std::size_t running() const;
  [[nodiscard]] std::size_t queued() const;
  [[nodiscard]] const Limits& limits() const { return limits_; }

 private:
  using Clock = FairQueue::Clock;
  struct Running {
    Clock::time_point since;
    std::function<void(const Error&)> overdue;  ///< empty once called
  };

  void work();
  void watch();
  void refuse_late(std::unique_lock<std::mutex>& lock);
  void tell_overdue(std::unique_lock<std::mutex>& lock);
  [[nodiscard]] Clock::time_point next_event() const;
  [[nodiscard]] double retry_delay();

  const Limits limits_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;        ///< workers
  std::condition_variable wake_watch_;  ///< the thread that looks at the clock
  FairQueue queue_;
  std::map<WorkId, Running> running_;
  WorkId next_id_ = 1;
  double mean_seconds_ = 1;  ///< of work; an exponential moving average
  Jitter jitter_;
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace remeshd
