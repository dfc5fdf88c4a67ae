#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <stop_token>
#include <utility>

namespace remeshd {

/// The memory of the daemon as one sum, from which everything that needs much takes its estimate:
/// computations and loads by a lease for as long as they last, requests that wait in streams, and
/// the revisions held, which give way to the others where they can be read again.
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

   private:
    friend class MemoryBudget;
    Lease(MemoryBudget& budget, std::uint64_t bytes) : budget_(&budget), bytes_(bytes) {}
    MemoryBudget* budget_ = nullptr;
    std::uint64_t bytes_ = 0;
  };
  /// Makes the revisions held take no more than this many bytes, as far as it can; returns how many
  /// they take.
  using Reclaim = std::function<std::uint64_t(std::uint64_t most)>;
  /// What the process has in fact. Estimates leave out the program itself, what the allocator keeps
  /// of freed memory, buffers of connections.
  struct Process {
    std::function<std::uint64_t()> resident;    ///< bytes
    std::function<void()> return_freed_memory;  ///< to the system; takes some ms
  };

  explicit MemoryBudget(std::uint64_t total) : total_(total) {}
  MemoryBudget(const MemoryBudget&) = delete;
  MemoryBudget& operator=(const MemoryBudget&) = delete;

  /// Before anything is leased. Called under the budget's mutex.
  void set_reclaim(Reclaim reclaim) { reclaim_ = std::move(reclaim); }

  /// Before anything is leased: the revisions held give way too where the process would pass the
  /// budget, though the estimates do not. Nothing is refused for that.
  void set_process(Process process) { process_ = std::move(process); }

  /// Empty where there is no room now.
  Lease try_take(std::uint64_t bytes);
  /// Waits until there is room; empty once `stop` asks for it. Throws Error: MESH_TOO_LARGE for
  /// more than there is in all, MEMORY_FULL where there was none within `seconds`.
  Lease take(std::uint64_t bytes, const std::stop_token& stop, double seconds);

  [[nodiscard]] std::uint64_t total() const { return total_; }
  [[nodiscard]] std::uint64_t leased() const;
  /// What the revisions held may take.
  [[nodiscard]] std::uint64_t left() const;

 private:
  bool take_now(std::uint64_t bytes);
  void keep_process_within(std::uint64_t bytes);
  void give_back(std::uint64_t bytes);

  const std::uint64_t total_;
  Reclaim reclaim_;
  Process process_;
  mutable std::mutex mutex_;
  std::condition_variable_any returned_;
  std::uint64_t leased_ = 0;
};

}  // namespace remeshd
