#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "engine/revision/storage/memory_use.h"
#include "server/admission/memory_budget.h"
#include "server/session/held_revision.h"

namespace remeshd {

/// A tenant's revisions in memory; memory that several share counts once. Where they can be read
/// from the store again, the least recently used are evicted as soon as the budget, which bounds
/// what all tenants hold, asks for it. A revision in use is not evicted, for that would free no
/// memory; one that is erased while in use counts until its last user has released it.
class HeldRevisions {
 public:
  using MemoryBlocks = std::function<std::vector<MemoryBlock>(const Revision&)>;

  /// `blocks_of`: the memory of a revision that others may share. `evict`: whether revisions can be
  /// read again, and so be evicted. `evicted`: called for each that was, under locks; may be empty.
  /// The budget must outlive it.
  HeldRevisions(MemoryBudget& budget, bool evict, MemoryBlocks blocks_of,
                std::function<void()> evicted = {});
  ~HeldRevisions();
  HeldRevisions(const HeldRevisions&) = delete;
  HeldRevisions& operator=(const HeldRevisions&) = delete;

  HeldRevisionPtr find(const std::string& id);
  [[nodiscard]] bool contains(const std::string& id) const;
  void insert(HeldRevisionPtr revision);
  void erase(const std::string& id);

  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] std::uint64_t bytes() const;
  /// Bytes that a revision shares with no other; 0 where it is not held.
  [[nodiscard]] std::uint64_t own_bytes(const std::string& id) const;

 private:
  using Order = std::list<HeldRevisionPtr>;  ///< used last in front
  struct Memory {
    std::uint64_t own = 0;
    std::vector<MemoryBlock> blocks;
  };
  struct Block {
    std::uint64_t bytes = 0;
    std::size_t revisions = 0;  ///< that have it
  };
  struct Leaving {
    std::weak_ptr<const HeldRevision> revision;
    Memory memory;
  };

  [[nodiscard]] Memory memory_of(const HeldRevision& revision) const;
  Order::iterator drop(Order::iterator entry);
  void count(const Memory& memory);
  void discount(const Memory& memory) const;
  void discount_what_left() const;
  void shrink(std::uint64_t most);

  MemoryBudget& budget_;
  const bool evict_;
  const MemoryBlocks blocks_of_;
  const std::function<void()> evicted_;
  mutable std::mutex mutex_;
  Order order_;
  std::unordered_map<std::string, Order::iterator> by_id_;
  // Mutable: const functions too discount revisions whose last user has gone.
  mutable std::vector<Leaving> leaving_;  ///< erased while in use
  mutable std::unordered_map<const void*, Block> blocks_;
  mutable std::uint64_t bytes_ = 0;
  const MemoryBudget::HolderId holder_;
};

}  // namespace remeshd
