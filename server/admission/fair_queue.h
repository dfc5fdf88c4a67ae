#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "engine/base/error.h"

namespace remeshd {

/// Something to be done by a worker for a tenant.
struct Work {
  std::string tenant;  ///< empty: that of a daemon without tokens
  std::function<void()> run;
  /// Called instead of `run` where the work waited too long or the daemon ends.
  std::function<void(const Error&)> refused;
  /// Called while `run` is under way, once that has taken too long; has to make `run` end. May be
  /// empty.
  std::function<void(const Error&)> overdue{};
};
using WorkId = std::uint64_t;

/// Decides which work is next, fairly among tenants. A tenant that asked within the last 60 s, or
/// has work here, is active. While several tenants are active, each has its share of the places; no
/// tenant holds all workers, unless there is one worker only; and a free worker goes to the tenant
/// that holds the fewest workers, among equals to the one that was served longest ago. Work of one
/// tenant is first come, first served.
///
/// Not safe for several threads; does not look at the clock itself.
class FairQueue {
 public:
  using Clock = std::chrono::steady_clock;
  using Time = Clock::time_point;
  struct Entry {
    WorkId id = 0;
    Time since;  ///< when it came
    Work work;
  };

  /// `places`: how much work may wait, beside what idle workers take at once.
  FairQueue(std::size_t workers, std::size_t places) : workers_(workers), places_(places) {}

  /// How much more work the tenant may add now. Makes the tenant active.
  std::size_t room(const std::string& tenant, Time now);
  void add(Entry entry);
  /// Takes out the work that is next; nothing where none waits or no tenant may have a worker. It
  /// counts as running until `ended`.
  std::optional<Entry> take(Time now);
  void ended(const std::string& tenant);
  /// Takes out waiting work; false if it does not wait (any more).
  bool withdraw(WorkId id);
  /// Takes out everything.
  std::deque<Entry> clear();

  /// When the oldest waiting work came; nothing where none waits.
  [[nodiscard]] std::optional<Time> oldest() const;
  /// Takes out the oldest waiting work, if it came at `time` or before.
  std::optional<Entry> take_older_than(Time time);
  [[nodiscard]] std::size_t waiting() const { return waiting_; }
  [[nodiscard]] std::size_t running() const { return running_; }

 private:
  struct Tenant {
    std::deque<Entry> waiting;
    std::size_t running = 0;
    Time asked;
    Time served = Time::min();  ///< last
  };
  using Tenants = std::map<std::string, Tenant>;

  void forget_idle(Time now);
  Entry pop(Tenant& tenant);
  /// The tenant with the oldest waiting entry; end() where none waits.
  [[nodiscard]] Tenants::const_iterator longest_waiting() const;

  const std::size_t workers_, places_;
  Tenants tenants_;  ///< the active ones
  std::size_t waiting_ = 0, running_ = 0;
};

}  // namespace remeshd
