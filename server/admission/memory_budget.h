#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

#include "engine/base/error.h"
#include "server/admission/fair_cap.h"
#include "server/admission/jitter.h"

namespace remeshd {

/// One budget for all memory of the daemon that is worth counting, by estimates. Computations and
/// loads lease theirs for as long as they last, streams for what waits in them. The rest may be
/// taken by revisions held in memory, which give way to leases where they can be read again, those
/// of the tenants that hold most first.
class MemoryBudget {
 public:
  /// Bytes of the budget, given back by the destructor.
  class Lease {
   public:
    Lease() = default;
    Lease(Lease&& other) noexcept
        : budget_(std::exchange(other.budget_, nullptr)), bytes_(other.bytes_) {}
    Lease& operator=(Lease&& other) noexcept {
      std::swap(budget_, other.budget_);
      std::swap(bytes_, other.bytes_);
      return *this;
    }
    ~Lease() {
      if (budget_ != nullptr) budget_->give_back(bytes_);
    }
    explicit operator bool() const { return budget_ != nullptr; }

    /// Changes the lease to `bytes`; false, and nothing done, where there is no room for more.
    /// Pre: not empty.
    bool try_resize(std::uint64_t bytes);
    /// The same for memory that is in use already: it is counted even where there is no room.
    void resize(std::uint64_t bytes);

   private:
    friend class MemoryBudget;
    Lease(MemoryBudget& budget, std::uint64_t bytes) : budget_(&budget), bytes_(bytes) {}
    MemoryBudget* budget_ = nullptr;
    std::uint64_t bytes_ = 0;
  };
  /// Measures what the process really takes: estimates leave out the program itself, what the
  /// allocator keeps of freed memory, buffers of connections.
  struct Process {
    std::function<std::uint64_t()> resident;    ///< bytes
    std::function<void()> return_freed_memory;  ///< to the system; takes some ms
  };

  /// `most_held`: bytes of `total` that revisions held may take at most; none: all that is not
  /// leased.
  explicit MemoryBudget(std::uint64_t total, std::optional<std::uint64_t> most_held = std::nullopt)
      : total_(total), most_held_(most_held.value_or(total)) {}
  MemoryBudget(const MemoryBudget&) = delete;
  MemoryBudget& operator=(const MemoryBudget&) = delete;

  /// Adds a holder of revisions, until `remove_holder`, which waits for a running call of the
  /// holder's functions. These must not use the budget.
  using HolderId = std::uint64_t;
  HolderId add_holder(BudgetHolder holder);
  void remove_holder(HolderId id);
  /// Makes the holders give way where together they have more than they may. To be called by a
  /// holder whose bytes have changed, without a lock that its functions take.
  void trim();
  /// Calls `listener` now, and whenever `trim` finds a change, with whether the memory for
  /// revisions is full: holders that cannot evict (`gives_way` is false) have `most_held` bytes or
  /// more. Then no revision can be made until one is deleted. The listener must not use the budget;
  /// an empty one removes the former.
  void on_full(std::function<void(bool full)> listener);

  /// Makes revisions held give way also where the measured process would exceed the budget and the
  /// estimates do not; no lease is refused for that. To be called before anything is leased.
  void set_process(Process process) { process_ = std::move(process); }

  /// Empty where there is no room now.
  Lease try_take(std::uint64_t bytes);
  /// Waits until there is room; empty once `stop` is requested. Throws Error: MESH_TOO_LARGE for
  /// more than the whole budget, MEMORY_FULL where there was no room within `seconds`.
  Lease take(std::uint64_t bytes, const std::stop_token& stop, double seconds);

  /// The error for a request that finds no room: MEMORY_FULL, with a retry delay.
  [[nodiscard]] Error full();

  [[nodiscard]] std::uint64_t total() const { return total_; }
  [[nodiscard]] std::uint64_t most_held() const { return most_held_; }
  /// Bytes of all revisions held.
  [[nodiscard]] std::uint64_t held() const;
  [[nodiscard]] std::uint64_t leased() const;
  /// Bytes that are not leased.
  [[nodiscard]] std::uint64_t left() const;

 private:
  [[nodiscard]] std::uint64_t sum_held() const;
  [[nodiscard]] std::uint64_t unleased() const { return total_ - std::min(total_, leased_); }
  std::uint64_t reclaim(std::uint64_t most);
  bool take_now(std::uint64_t bytes);
  void keep_process_within(std::uint64_t bytes);
  void give_back(std::uint64_t bytes);
  void count(std::uint64_t bytes);
  void tell_full();
  [[nodiscard]] Error full_now();

  const std::uint64_t total_, most_held_;
  Process process_;
  mutable std::mutex mutex_;
  std::map<HolderId, BudgetHolder> holders_;
  HolderId next_holder_ = 1;
  std::condition_variable_any returned_;
  std::uint64_t leased_ = 0;
  Jitter jitter_;
  bool full_ = false;
  std::function<void(bool)> full_listener_;
};

}  // namespace remeshd
