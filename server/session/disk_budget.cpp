#include "server/session/disk_budget.h"

#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace remeshd {

DiskBudget::DiskBudget(std::uint64_t most)
    : most_(most),
      collector_(most > 0 ? std::function<bool()>([this] { return collect(); })
                          : std::function<bool()>()) {}

DiskBudget::HolderId DiskBudget::add_holder(BudgetHolder holder) {
  const std::scoped_lock lock(mutex_);
  holders_.emplace(next_holder_, std::move(holder));
  return next_holder_++;
}

void DiskBudget::remove_holder(HolderId id) {
  const std::scoped_lock lock(mutex_);
  holders_.erase(id);
}

std::uint64_t DiskBudget::cap_now() const {
  if (most_ == 0) return std::numeric_limits<std::uint64_t>::max();
  std::vector<std::uint64_t> amounts;
  for (const auto& [id, holder] : holders_) amounts.push_back(holder.bytes());
  return fair_cap(std::move(amounts), most_);
}

std::uint64_t DiskBudget::cap() const {
  const std::scoped_lock lock(mutex_);
  return cap_now();
}

bool DiskBudget::collect() {
  const std::scoped_lock lock(mutex_);
  const std::uint64_t cap = cap_now();
  bool again = false;
  for (const auto& [id, holder] : holders_) {
    if (holder.bytes() <= cap) continue;
    bool done = false;
    contained([&] {
      holder.shrink(cap);
      done = true;
    });
    again |= !done;
  }
  return again;
}

}  // namespace remeshd
