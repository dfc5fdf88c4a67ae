#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/base/error.h"

namespace remeshd {

/// A bounded number of threads before a bounded queue, first come, first served.
///
/// Inv: of each submitted job exactly one happens: it runs, it is refused, or it is withdrawn.
class Pool {
 public:
  struct Limits {
    int workers = 1;
    std::size_t queue = 64;  ///< jobs that may wait
    double wait = 60;        ///< s; who waits longer is refused
  };
  using JobId = std::uint64_t;

  explicit Pool(Limits limits);
  /// As `shutdown`.
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  /// `refused` gets `WAITED_TOO_LONG` or `SHUTTING_DOWN`. What either throws is dropped: whoever
  /// waits for an answer has to be told by the job itself. Throws Error(`BUSY`) with a retry delay
  /// where the queue is full, `SHUTTING_DOWN` after shutdown.
  JobId submit(std::function<void()> run, std::function<void(const Error&)> refused);
  /// Takes a job out of the queue; false if it is not there any more.
  bool withdraw(JobId id);
  /// Refuses what waits and returns when what runs has ended. Not to be called by a job.
  void shutdown();

  [[nodiscard]] std::size_t running() const;
  [[nodiscard]] std::size_t queued() const;
  [[nodiscard]] const Limits& limits() const { return limits_; }

 private:
  using Clock = std::chrono::steady_clock;
  struct Job {
    JobId id;
    Clock::time_point since;
    std::function<void()> run;
    std::function<void(const Error&)> refused;
  };

  void work();
  void watch();
  [[nodiscard]] double retry_delay() const;

  const Limits limits_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;        ///< workers
  std::condition_variable wake_watch_;  ///< the thread that refuses what waits too long
  std::deque<Job> queue_;
  std::size_t running_ = 0;
  JobId next_id_ = 1;
  double mean_seconds_ = 1;  ///< of a job, newer ones weigh more
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace remeshd
