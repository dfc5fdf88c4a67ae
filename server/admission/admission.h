#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "server/admission/pool.h"

namespace remeshd {

/// Who may come in, asked before anything of a request is read. As many of a tenant may be prepared
/// at a time as the computation lane has room for. Where it has none, a few a second come in all
/// the same: what they ask for may be there already.
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
  std::map<std::string, std::size_t> preparing_;  ///< by tenant
  double spare_places_ = 0;                       ///< filled by the second

  Clock::time_point refilled_{};
};

}  // namespace remeshd
