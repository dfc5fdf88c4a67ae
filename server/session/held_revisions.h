#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>

#include "engine/remesh/remesh.h"
#include "server/store/records.h"

namespace remeshd {

/// A revision in memory with what is known of it. Its report names it; `cached` is false.
struct HeldRevision {
  RevisionRecord record;
  Revision revision;
};
using HeldRevisionPtr = std::shared_ptr<const HeldRevision>;

/// About how many bytes a revision takes in memory.
std::uint64_t memory_of(const Revision& revision);

/// Revisions in memory. Where others can be read from the store again, those used longest ago go as
/// soon as all together pass the budget; whoever still uses one keeps it alive.
class HeldRevisions {
 public:
  HeldRevisions(std::uint64_t budget, bool evict) : budget_(budget), evict_(evict) {}

  HeldRevisionPtr find(const std::string& id);
  [[nodiscard]] bool contains(const std::string& id) const;
  void insert(HeldRevisionPtr revision);
  void erase(const std::string& id);

  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] std::uint64_t bytes() const;
  [[nodiscard]] std::uint64_t budget() const { return budget_; }

 private:
  struct Entry {
    HeldRevisionPtr revision;
    std::uint64_t bytes = 0;
  };
  using Order = std::list<Entry>;  ///< used last in front

  void drop(Order::iterator entry);

  const std::uint64_t budget_;
  const bool evict_;
  mutable std::mutex mutex_;
  Order order_;
  std::unordered_map<std::string, Order::iterator> by_id_;
  std::uint64_t bytes_ = 0;
};

}  // namespace remeshd
