#include "server/session/held_revisions.h"

#include <algorithm>

namespace remeshd {
namespace {

/// Estimates the bytes of a revision that it never shares with others.
std::uint64_t own_memory(const HeldRevision& held) {
  const Revision& revision = held.revision;
  const auto bytes_of = [](const auto& values) { return values.size() * sizeof(values[0]); };
  std::uint64_t bytes = 0;
  // Twice: what the boundary is joined from is kept too, with shapes of the CAD kernel.
  const BoundaryModel& boundary = revision.cells.boundary;
  for (const BoundaryFace& face : boundary.faces)
    bytes += 2 * (bytes_of(face.points) + bytes_of(face.triangles));
  // Models, names, shapes of the CAD kernel: some 20 KB a feature or face.
  return bytes + held.edit.size() + 4096 +
         20000 * (revision.model.features.size() + boundary.faces.size());
}

}  // namespace

HeldRevisions::HeldRevisions(MemoryBudget& budget, bool evict, MemoryBlocks blocks_of,
                             std::function<void()> evicted)
    : budget_(budget),
      evict_(evict),
      blocks_of_(std::move(blocks_of)),
      evicted_(std::move(evicted)),
      holder_(budget_.add_holder({.bytes = [this] { return bytes(); },
                                  .shrink = [this](std::uint64_t most) { shrink(most); },
                                  .gives_way = evict})) {}

HeldRevisions::~HeldRevisions() { budget_.remove_holder(holder_); }

HeldRevisionPtr HeldRevisions::find(const std::string& id) {
  const std::scoped_lock lock(mutex_);
  const auto entry = by_id_.find(id);
  if (entry == by_id_.end()) return nullptr;
  order_.splice(order_.begin(), order_, entry->second);
  return *entry->second;
}

bool HeldRevisions::contains(const std::string& id) const {
  const std::scoped_lock lock(mutex_);
  return by_id_.contains(id);
}

HeldRevisions::Memory HeldRevisions::memory_of(const HeldRevision& revision) const {
  return {own_memory(revision), blocks_of_(revision.revision)};
}

void HeldRevisions::count(const Memory& memory) {
  bytes_ += memory.own;
  for (const MemoryBlock& block : memory.blocks) {
    Block& counted = blocks_[block.address];
    if (counted.revisions++ > 0) continue;
    counted.bytes = block.bytes;
    bytes_ += block.bytes;
  }
}

void HeldRevisions::discount(const Memory& memory) const {
  bytes_ -= memory.own;
  for (const MemoryBlock& block : memory.blocks) {
    const auto counted = blocks_.find(block.address);
    if (--counted->second.revisions > 0) continue;
    bytes_ -= counted->second.bytes;
    blocks_.erase(counted);
  }
}

void HeldRevisions::discount_what_left() const {
  std::erase_if(leaving_, [this](const Leaving& leaving) {
    if (!leaving.revision.expired()) return false;
    discount(leaving.memory);
    return true;
  });
}

HeldRevisions::Order::iterator HeldRevisions::drop(Order::iterator entry) {
  Memory memory = memory_of(**entry);
  if (entry->use_count() > 1) {
    leaving_.push_back({*entry, std::move(memory)});
  } else {
    discount(memory);
  }
  by_id_.erase((*entry)->record.id);
  return order_.erase(entry);
}

/// Drops those used longest ago until all together have at most `most` bytes. The newest stays
/// however large it is: the next request most likely asks for it.
void HeldRevisions::shrink(std::uint64_t most) {
  if (!evict_) return;
  const std::scoped_lock lock(mutex_);
  discount_what_left();
  for (auto entry = order_.end(); bytes_ > most && entry != order_.begin();) {
    --entry;
    if (entry == order_.begin()) break;
    if (entry->use_count() > 1) continue;
    entry = drop(entry);
    if (evicted_) evicted_();
  }
}

void HeldRevisions::insert(HeldRevisionPtr revision) {
  const Memory memory = memory_of(*revision);
  {
    const std::scoped_lock lock(mutex_);
    discount_what_left();
    std::erase_if(leaving_, [&](const Leaving& leaving) {
      if (leaving.revision.lock() != revision) return false;
      discount(leaving.memory);
      return true;
    });
    const std::string& id = revision->record.id;
    if (const auto entry = by_id_.find(id); entry != by_id_.end()) {
      if (*entry->second == revision) return order_.splice(order_.begin(), order_, entry->second);
      drop(entry->second);
    }
    order_.push_front(std::move(revision));
    by_id_[order_.front()->record.id] = order_.begin();
    count(memory);
  }
  budget_.trim();
}

void HeldRevisions::erase(const std::string& id) {
  {
    const std::scoped_lock lock(mutex_);
    const auto entry = by_id_.find(id);
    if (entry == by_id_.end()) return;
    drop(entry->second);
  }
  budget_.trim();
}

std::size_t HeldRevisions::count() const {
  const std::scoped_lock lock(mutex_);
  return order_.size();
}
std::uint64_t HeldRevisions::bytes() const {
  const std::scoped_lock lock(mutex_);
  discount_what_left();
  return bytes_;
}

std::uint64_t HeldRevisions::own_bytes(const std::string& id) const {
  const std::scoped_lock lock(mutex_);
  const auto entry = by_id_.find(id);
  if (entry == by_id_.end()) return 0;
  const Memory memory = memory_of(**entry->second);
  std::uint64_t bytes = memory.own;
  for (const MemoryBlock& block : memory.blocks)
    if (blocks_.at(block.address).revisions == 1) bytes += block.bytes;
  return bytes;
}

}  // namespace remeshd
