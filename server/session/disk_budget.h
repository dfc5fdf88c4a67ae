#pragma once

#include <cstdint>
#include <map>
#include <mutex>

#include "server/admission/fair_cap.h"
#include "server/session/background.h"

namespace remeshd {

/// The disk space that the stored meshes of all tenants may take together. Where they take more,
/// meshes are dropped, first those of the tenants that have most. For what a tenant cannot drop
/// (pins, meshes without a recipe) no other gives way: then more is taken than the budget.
class DiskBudget {
 public:
  /// `most`: bytes; 0: any.
  explicit DiskBudget(std::uint64_t most);
  DiskBudget(const DiskBudget&) = delete;
  DiskBudget& operator=(const DiskBudget&) = delete;

  /// Adds a holder of stored meshes, until `remove_holder`, which waits for a running call of the
  /// holder's functions. These must not use the budget, but for `look_soon`.
  using HolderId = std::uint64_t;
  HolderId add_holder(BudgetHolder holder);
  void remove_holder(HolderId id);

  /// To be called when something was stored: the budget's own thread soon drops what is too much.
  void look_soon() { collector_.ask(); }
  /// Bytes that each holder may have now, as `fair_cap`. Waits while meshes are being dropped.
  [[nodiscard]] std::uint64_t cap() const;
  [[nodiscard]] std::uint64_t most() const { return most_; }

 private:
  [[nodiscard]] std::uint64_t cap_now() const;
  /// True where it has to be tried again.
  bool collect();

  const std::uint64_t most_;
  mutable std::mutex mutex_;
  std::map<HolderId, BudgetHolder> holders_;
  HolderId next_holder_ = 1;
  Background collector_;  ///< last: it uses what stands before it
};

}  // namespace remeshd
