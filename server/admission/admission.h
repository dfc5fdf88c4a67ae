#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "server/admission/pool.h"

namespace remeshd {

/// Decides which requests are let in, before anything of them is read. A tenant may have as many
/// requests in preparation at a time as the computation lane has room for. Beyond that a few a
/// second are let in all the same: what they ask for may be there already, so that nothing is
/// computed for them.
class Admission {
 public:
  /// Held while a request is prepared. Must not outlive the admission.
  class Ticket {
   public:
    Ticket(Admission& admission, std::string tenant)
        : admission_(admission), tenant_(std::move(tenant)) {}
    Ticket(const Ticket&) = delete;
    Ticket& operator=(const Ticket&) = delete;
    ~Ticket() { admission_.leave(tenant_); }
    [[nodiscard]] const std::string& tenant() const { return tenant_; }

   private:
    Admission& admission_;
    const std::string tenant_;
  };
  using TicketPtr = std::shared_ptr<const Ticket>;

  explicit Admission(Pool& computation) : computation_(computation) {}

  /// Throws Error(`BUSY`) with a retry delay, `SHUTTING_DOWN`.
  TicketPtr admit(const std::string& tenant);

 private:
  using Clock = FairQueue::Clock;

  void leave(const std::string& tenant);
  bool take_spare_place();

  Pool& computation_;
  std::mutex mutex_;
  std::map<std::string, std::size_t> preparing_;  ///< requests that hold a ticket, by tenant
  double spare_places_ = 0;                       ///< refilled over time, see limits::kSparePlaces

  Clock::time_point refilled_{};
};

}  // namespace remeshd
