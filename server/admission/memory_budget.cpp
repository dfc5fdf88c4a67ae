#include "server/admission/memory_budget.h"

#include <algorithm>
#include <chrono>

#include "server/admission/load_error.h"
#include "server/limits.h"

namespace remeshd {
namespace {

// s between attempts while `take` waits: the budget is not notified when the last user of an erased
// revision ends.
constexpr double kLookAgain = 0.1;

}  // namespace

MemoryBudget::HolderId MemoryBudget::add_holder(BudgetHolder holder) {
  const std::scoped_lock lock(mutex_);
  holders_.emplace(next_holder_, std::move(holder));
  return next_holder_++;
}

void MemoryBudget::remove_holder(HolderId id) {
  const std::scoped_lock lock(mutex_);
  holders_.erase(id);
}

std::uint64_t MemoryBudget::sum_held() const {
  std::uint64_t sum = 0;
  for (const auto& [id, holder] : holders_) sum += holder.bytes();
  return sum;
}

/// Makes the holders give way until together they have at most `most` bytes, as far as they can;
/// returns how many they have. Where one cannot let go of something, the others give way for it.
std::uint64_t MemoryBudget::reclaim(std::uint64_t most) {
  struct Share {
    const BudgetHolder* holder;
    std::uint64_t bytes;
    bool in_use = false;  ///< the holder could not let go of it
  };
  std::vector<Share> shares;
  for (const auto& [id, holder] : holders_) shares.push_back({&holder, holder.bytes()});
  for (;;) {
    std::vector<std::uint64_t> amounts;
    std::uint64_t in_use = 0, sum = 0;
    for (const Share& share : shares) {
      if (share.in_use)
        in_use += share.bytes;
      else
        amounts.push_back(share.bytes);
    }
    const std::uint64_t cap = fair_cap(std::move(amounts), most - std::min(most, in_use));
    bool again = false;
    for (Share& share : shares) {
      if (!share.in_use && share.bytes > cap) {
        share.holder->shrink(cap);
        share.bytes = share.holder->bytes();
        again |= share.in_use = share.bytes > cap;
      }
      sum += share.bytes;
    }
    if (!again) return sum;
  }
}

void MemoryBudget::trim() {
  const std::scoped_lock lock(mutex_);
  reclaim(std::min(most_held_, unleased()));
  tell_full();
}

void MemoryBudget::on_full(std::function<void(bool)> listener) {
  const std::scoped_lock lock(mutex_);
  full_listener_ = std::move(listener);
  if (full_listener_) full_listener_(full_);
}

void MemoryBudget::tell_full() {
  std::uint64_t staying = 0;
  for (const auto& [id, holder] : holders_)
    if (!holder.gives_way) staying += holder.bytes();
  const bool full = staying > 0 && staying >= most_held_;
  if (std::exchange(full_, full) != full && full_listener_) full_listener_(full);
}

bool MemoryBudget::take_now(std::uint64_t bytes) {
  if (bytes > total_ || leased_ > total_ - bytes) return false;
  const std::uint64_t left = total_ - leased_ - bytes;
  if (reclaim(left) > left) return false;
  // Leased memory may not be allocated yet, so all of it is added to what the process takes now.
  keep_process_within(left);
  leased_ += bytes;
  return true;
}

void MemoryBudget::keep_process_within(std::uint64_t bytes) {
  const std::uint64_t margin = total_ / limits::kMarginShare;
  if (!process_.resident || process_.resident() + margin <= bytes) return;
  process_.return_freed_memory();
  const std::uint64_t wanted = process_.resident() + 2 * margin;
  if (wanted <= bytes) return;
  const std::uint64_t excess = wanted - bytes, held = sum_held();
  reclaim(std::max(total_ / limits::kKeptShare, held > excess ? held - excess : 0));
  process_.return_freed_memory();
}

MemoryBudget::Lease MemoryBudget::try_take(std::uint64_t bytes) {
  const std::scoped_lock lock(mutex_);
  return take_now(bytes) ? Lease(*this, bytes) : Lease();
}

MemoryBudget::Lease MemoryBudget::take(std::uint64_t bytes, const std::stop_token& stop,
                                       double seconds) {
  using Clock = std::chrono::steady_clock;
  if (bytes > total_) throw error::never_fits(bytes, total_);
  const auto until = Clock::now() + std::chrono::duration<double>(seconds);
  std::unique_lock lock(mutex_);
  while (!take_now(bytes)) {
    if (stop.stop_requested()) return {};
    if (Clock::now() >= until) throw full_now();
    returned_.wait_for(lock, stop, std::chrono::duration<double>(kLookAgain),
                       [&, before = leased_] { return leased_ < before; });
  }
  return {*this, bytes};
}

void MemoryBudget::count(std::uint64_t bytes) {
  const std::scoped_lock lock(mutex_);
  leased_ += bytes;
  reclaim(std::min(most_held_, unleased()));
}

bool MemoryBudget::Lease::try_resize(std::uint64_t bytes) {
  if (bytes > bytes_) {
    const std::scoped_lock lock(budget_->mutex_);
    if (!budget_->take_now(bytes - bytes_)) return false;
  } else if (bytes < bytes_) {
    budget_->give_back(bytes_ - bytes);
  }
  bytes_ = bytes;
  return true;
}

void MemoryBudget::Lease::resize(std::uint64_t bytes) {
  if (bytes > bytes_) budget_->count(bytes - bytes_);
  if (bytes < bytes_) budget_->give_back(bytes_ - bytes);
  bytes_ = bytes;
}

void MemoryBudget::give_back(std::uint64_t bytes) {
  {
    const std::scoped_lock lock(mutex_);
    leased_ -= bytes;
  }
  returned_.notify_all();
}

Error MemoryBudget::full_now() {
  return error::memory_full(leased_ + sum_held(), total_, jitter_.of(limits::kMemoryDelay));
}

Error MemoryBudget::full() {
  const std::scoped_lock lock(mutex_);
  return full_now();
}

std::uint64_t MemoryBudget::leased() const {
  const std::scoped_lock lock(mutex_);
  return leased_;
}

std::uint64_t MemoryBudget::held() const {
  const std::scoped_lock lock(mutex_);
  return sum_held();
}

std::uint64_t MemoryBudget::left() const {
  const std::scoped_lock lock(mutex_);
  return unleased();
}

}  // namespace remeshd
