#include "server/session/computations.h"

#include <algorithm>
#include <utility>

namespace remeshd {

Computations::Entry Computations::enter(const WaitingRequestPtr& request,
                                        const Prepared& prepared) {
  const std::scoped_lock lock(mutex_);
  if (request->answered()) return Entry::Answered;
  const auto under_way = by_id_.find(prepared.id);
  if (under_way != by_id_.end()) {
    under_way->second->waiting.push_back(request);
    request->joined = under_way->second;
    return Entry::Waits;
  }
  if (tasks_.is_made(prepared.id)) return Entry::IsMade;
  const auto computation = std::make_shared<Computation>();
  computation->prepared = prepared;
  computation->waiting.push_back(request);
  const auto failed = [this, computation](const Error& why) { tasks_.failed(computation, why); };
  computation->work = lane_.submit({.tenant = request->tenant(),
                                    .run = [this, computation] { tasks_.compute(computation); },
                                    .refused = failed,
                                    .overdue =
                                        [computation, failed](const Error& why) {
                                          computation->stop.request_stop();
                                          failed(why);
                                        }});
  request->joined = computation;
  by_id_.emplace(prepared.id, computation);
  return Entry::Waits;
}

/// Pre: under the mutex.
void Computations::erase(const ComputationPtr& computation) {
  const auto entry = by_id_.find(computation->prepared.id);
  if (entry != by_id_.end() && entry->second == computation) by_id_.erase(entry);
}

std::vector<WaitingRequestPtr> Computations::remove(const ComputationPtr& computation) {
  const std::scoped_lock lock(mutex_);
  erase(computation);
  return std::exchange(computation->waiting, {});
}

std::vector<WaitingRequestPtr> Computations::waiting_for(const ComputationPtr& computation) const {
  const std::scoped_lock lock(mutex_);
  return computation->waiting;
}

void Computations::leave(const WaitingRequestPtr& request) {
  const std::scoped_lock lock(mutex_);
  const ComputationPtr computation = request->joined.lock();
  if (!computation) return;
  if (std::erase(computation->waiting, request) == 0 || !computation->waiting.empty()) return;
  // A request for the same revision from now on starts afresh.
  computation->stop.request_stop();
  lane_.withdraw(computation->work);
  erase(computation);
}

std::size_t Computations::waiting() const {
  const std::scoped_lock lock(mutex_);
  std::size_t waiting = 0;
  for (const auto& [id, computation] : by_id_) waiting += computation->waiting.size();
  return waiting;
}

}  // namespace remeshd
