#include "server/admission/fair_queue.h"

#include <algorithm>
#include <utility>
#include "server/limits.h"

namespace remeshd {
void FairQueue::forget_idle(Time now) {
  std::erase_if(tenants_, [now](const auto& entry) {
    const Tenant& tenant = entry.second;
    return tenant.waiting.empty() && tenant.running == 0 &&
           now - tenant.asked > limits::kActiveTenant;
  });
}

std::size_t FairQueue::room(const std::string& name, Time now) {
  Tenant& tenant = tenants_[name];
  tenant.asked = now;
  forget_idle(now);
  const auto left = [](std::size_t all, std::size_t taken) {
    return all > taken ? all - taken : 0;
  };
  const std::size_t idle = left(workers_, running_ + waiting_);
  if (tenants_.size() == 1) return idle + left(places_, left(waiting_, left(workers_, running_)));
  // A tenant that came first may have filled all places: the others get their shares all the same,
  // and more than `places_` may wait.
  const std::size_t share = std::max<std::size_t>(1, places_ / tenants_.size());
  return std::max(idle, left(share, tenant.waiting.size()));
}

void FairQueue::add(Entry entry) {
  Tenant& tenant = tenants_[entry.work.tenant];
  tenant.asked = std::max(tenant.asked, entry.since);
  tenant.waiting.push_back(std::move(entry));
  ++waiting_;
}

FairQueue::Entry FairQueue::pop(Tenant& tenant) {
  Entry entry = std::move(tenant.waiting.front());
  tenant.waiting.pop_front();
  --waiting_;
  return entry;
}

std::optional<FairQueue::Entry> FairQueue::take(Time now) {
  if (waiting_ == 0 || running_ >= workers_) return std::nullopt;
  forget_idle(now);
  const std::size_t most = tenants_.size() > 1 ? std::max<std::size_t>(1, workers_ - 1) : workers_;
  Tenant* next = nullptr;
  for (auto& [name, tenant] : tenants_) {
    if (tenant.waiting.empty() || tenant.running >= most) continue;
    if (next == nullptr || tenant.running < next->running ||
        (tenant.running == next->running && tenant.served < next->served))
      next = &tenant;
  }
  if (next == nullptr) return std::nullopt;
  next->served = now;
  ++next->running;
  ++running_;
  return pop(*next);
}

void FairQueue::ended(const std::string& tenant) {
  --tenants_.at(tenant).running;
  --running_;
}

bool FairQueue::withdraw(WorkId id) {
  for (auto& [name, tenant] : tenants_) {
    const auto entry = std::ranges::find(tenant.waiting, id, &Entry::id);
    if (entry == tenant.waiting.end()) continue;
    tenant.waiting.erase(entry);
    --waiting_;
    return true;
  }
  return false;
}

std::deque<FairQueue::Entry> FairQueue::clear() {
  std::deque<Entry> all;
  for (auto& [name, tenant] : tenants_)
    while (!tenant.waiting.empty()) all.push_back(pop(tenant));
  return all;
}

FairQueue::Tenants::const_iterator FairQueue::longest_waiting() const {
  auto longest = tenants_.end();
  for (auto tenant = tenants_.begin(); tenant != tenants_.end(); ++tenant) {
    if (tenant->second.waiting.empty()) continue;
    if (longest == tenants_.end() ||
        tenant->second.waiting.front().since < longest->second.waiting.front().since)
      longest = tenant;
  }
  return longest;
}

std::optional<FairQueue::Time> FairQueue::oldest() const {
  const auto tenant = longest_waiting();
  if (tenant == tenants_.end()) return std::nullopt;
  return tenant->second.waiting.front().since;
}

std::optional<FairQueue::Entry> FairQueue::take_older_than(Time time) {
  const auto tenant = longest_waiting();
  if (tenant == tenants_.end() || tenant->second.waiting.front().since > time) return std::nullopt;
  return pop(tenants_.at(tenant->first));
}

}  // namespace remeshd
