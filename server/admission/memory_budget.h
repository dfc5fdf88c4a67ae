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

/// The memory of the daemon as one sum, from which everything that needs much takes its estimate:
/// computations and loads by a lease for as long as they last, streams by one for what waits in
/// them, and the revisions held, which give way to the others where they can be read again. They
/// are held by tenants; of these, those that hold most give way first.
class MemoryBudget {
 public:
  /// A share of the budget, given back by its end.
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

    /// Makes it one of so many bytes; false, and nothing done, where there is no room for more.
    /// Pre: not empty.
    bool try_resize(std::uint64_t bytes);
    /// The same for what is there already: it counts though there is no room.
    void resize(std::uint64_t bytes);

   private:
    friend class MemoryBudget;
    Lease(MemoryBudget& budget, std::uint64_t bytes) : budget_(&budget), bytes_(bytes) {}
    MemoryBudget* budget_ = nullptr;
    std::uint64_t bytes_ = 0;
  };
  /// What the process has in fact. Estimates leave out the program itself, what the allocator keeps
  /// of freed memory, buffers of connections.
  struct Process {
    std::function<std::uint64_t()> resident;    ///< bytes
    std::function<void()> return_freed_memory;  ///< to the system; takes some ms
  };

  /// `most_held`: bytes of it that revisions held may take; none: as many as are left.
  explicit MemoryBudget(std::uint64_t total, std::optional<std::uint64_t> most_held = std::nullopt)
      : total_(total), most_held_(most_held.value_or(total)) {}
  MemoryBudget(const MemoryBudget&) = delete;
  MemoryBudget& operator=(const MemoryBudget&) = delete;

  /// Whoever holds revisions, until `remove_holder`, which waits for a call of its functions to
  /// return. They must not use the budget.
  using HolderId = std::uint64_t;
  HolderId add_holder(BudgetHolder holder);
  void remove_holder(HolderId id);
  /// Has the holders give way where together they have more than they may; for one that has more or
  /// less than before, which must not lock now what its functions lock.
  void trim();
  /// Hears now and at every change whether holders that do not give way have all that revisions
  /// may have: nothing more can be made until some of it is deleted. It must not use the budget;
  /// empty: nobody.
  void on_full(std::function<void(bool full)> listener);

  /// Before anything is leased: the revisions held give way too where the process would pass the
  /// budget, though the estimates do not. Nothing is refused for that.
  void set_process(Process process) { process_ = std::move(process); }

  /// Empty where there is no room now.
  Lease try_take(std::uint64_t bytes);
  /// Waits until there is room; empty once `stop` asks for it. Throws Error: MESH_TOO_LARGE for
  /// more than there is in all, MEMORY_FULL where there was none within `seconds`.
  Lease take(std::uint64_t bytes, const std::stop_token& stop, double seconds);

  /// What refuses a request that finds no room: MEMORY_FULL.
  [[nodiscard]] Error full();

  [[nodiscard]] std::uint64_t total() const { return total_; }
  [[nodiscard]] std::uint64_t most_held() const { return most_held_; }
  /// What all revisions held take.
  [[nodiscard]] std::uint64_t held() const;
  [[nodiscard]] std::uint64_t leased() const;
  /// What the revisions held may take.
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
