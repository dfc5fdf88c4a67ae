#pragma once

#include <cstdint>
#include <map>
#include <mutex>

#include "server/admission/fair_cap.h"
#include "server/session/background.h"

namespace remeshd {

/// The disk that the stored meshes of all tenants may take together. Where they take more, meshes
/// go, of those tenants first that have most. What a tenant cannot let go of (pins, meshes without
/// a recipe) nobody else gives way for: then more is taken than there should be.
class DiskBudget {
 public:
  /// `most`: bytes; 0: any.
  explicit DiskBudget(std::uint64_t most);
  DiskBudget(const DiskBudget&) = delete;
  DiskBudget& operator=(const DiskBudget&) = delete;

  /// Whoever stores meshes, until `remove_holder`, which waits for a call of its functions to
  /// return. They must not call back, but for `look_soon`.
  using HolderId = std::uint64_t;
  HolderId add_holder(BudgetHolder holder);
  void remove_holder(HolderId id);

  /// Something was stored: what is too much goes soon, on a thread of the budget's own.
  void look_soon() { collector_.ask(); }
  /// What each holder may have now; the greatest number there is while everything fits. Waits for
  /// meshes that are just going.
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
