#include "server/admission/admission.h"

#include <algorithm>
#include <chrono>

#include "server/admission/load_error.h"
#include "server/limits.h"

namespace remeshd {
bool Admission::take_spare_place() {
  const auto now = Clock::now();
  const std::chrono::duration<double> since = now - refilled_;
  spare_places_ =
      std::min(limits::kSparePlaces, spare_places_ + limits::kSparePlacesPerSecond * since.count());
  refilled_ = now;
  if (spare_places_ < 1) return false;
  --spare_places_;
  return true;
}

Admission::TicketPtr Admission::admit(const std::string& tenant) {
  const std::size_t room = computation_.room(tenant);
  {
    const std::scoped_lock lock(mutex_);
    std::size_t& preparing = preparing_[tenant];
    if (preparing < room || take_spare_place()) {
      ++preparing;
      return std::make_shared<const Ticket>(*this, tenant);
    }
    if (preparing == 0) preparing_.erase(tenant);
  }
  throw computation_.busy();
}

void Admission::leave(const std::string& tenant) {
  const std::scoped_lock lock(mutex_);
  const auto entry = preparing_.find(tenant);
  if (--entry->second == 0) preparing_.erase(entry);
}

}  // namespace remeshd
