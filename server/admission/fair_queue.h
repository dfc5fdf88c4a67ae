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
  std::string tenant;  ///< empty: the only one there is
  std::function<void()> run;
  /// Instead of `run`, where it waited too long or the daemon ends.
  std::function<void(const Error&)> refused;
  /// While it runs, once that has taken too long; may be empty. It has to see to it that `run`
  /// comes to its end.
  std::function<void(const Error&)> overdue{};
};
using WorkId = std::uint64_t;

/// Which work is next, by tenants. A tenant that asked within the last 60 s, or has work here, is
/// active. While more than one is, each has its share of the places, nobody holds more than all
/// workers but one, and a worker that is free goes to the tenant that holds fewest, of several to
/// the one that was served longest ago. A tenant's own work goes first come, first served.
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

  /// `places`: of what may wait, beside what idle workers take at once.
  FairQueue(std::size_t workers, std::size_t places) : workers_(workers), places_(places) {}

  /// How much more a tenant may add now. It is active from now on.
  std::size_t room(const std::string& tenant, Time now);
  void add(Entry entry);
  /// Takes out what is next; nothing where nobody may have a worker. It counts as held by its
  /// tenant until `ended`.
  std::optional<Entry> take(Time now);
  void ended(const std::string& tenant);
  /// Takes out what waits; false if it does not.
  bool withdraw(WorkId id);
  /// Takes out everything.
  std::deque<Entry> clear();

  /// When the oldest came; nothing where none waits.
  [[nodiscard]] std::optional<Time> oldest() const;
  /// Takes out the oldest, if it came before.
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
  /// Whose first entry is the oldest.
  [[nodiscard]] Tenants::const_iterator longest_waiting() const;

  const std::size_t workers_, places_;
  Tenants tenants_;  ///< the active ones
  std::size_t waiting_ = 0, running_ = 0;
};

}  // namespace remeshd
