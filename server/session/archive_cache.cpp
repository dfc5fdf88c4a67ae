#include <algorithm>
#include <limits>
#include <set>

#include "server/session/archive.h"
#include "server/session/clock.h"

// What meshes take of memory and disk, and which of them go.
namespace remeshd {

std::vector<StoredMesh> Archive::stored_meshes() {
  std::vector<StoredMesh> meshes;
  store_.read([&](Catalogue& catalogue) {
    const auto recipes = catalogue.recipes();
    std::map<std::string, bool> known;  // by id: whether it has a recipe
    for (const auto& [id, parent] : recipes) known[id] = true;
    for (const RevisionRecord& record : catalogue.revisions()) {
      const bool followed = record.algorithm_version == engine_.algorithm_version;
      meshes.push_back({.id = record.id,
                        .parent = record.parent,
                        .stored = record.bytes > 0,
                        .pinned = record.pinned,
                        .has_recipe = followed && known.contains(record.id),
                        .used_ns = record.created_ns,
                        .bytes = record.bytes});
      known.erase(record.id);
    }
    // Revisions that were deleted; which algorithm made them is seen when they are needed.
    for (const auto& [id, parent] : recipes)
      if (known.contains(id)) meshes.push_back({.id = id, .parent = parent, .has_recipe = true});
  });
  const std::scoped_lock lock(notes_);
  for (StoredMesh& mesh : meshes)
    if (const auto used = used_.find(mesh.id); used != used_.end()) mesh.used_ns = used->second;
  return meshes;
}

CacheEntry Archive::entry_of(const RevisionRecord& record, int depth) {
  CacheEntry entry{.record = record,
                   .memory_bytes = held_.own_bytes(record.id),
                   .depth = depth,
                   .used_ns = record.created_ns};
  if (record.bytes > 0) {
    entry.state = MeshState::Stored;
  } else if (held_.contains(record.id)) {
    entry.state = MeshState::Memory;
  } else {
    entry.state = record.algorithm_version == engine_.algorithm_version ? MeshState::Recipe
                                                                        : MeshState::Outdated;
  }
  const auto places =
      store_.read([&](Catalogue& catalogue) { return catalogue.places(record.id); });
  entry.places = static_cast<std::uint32_t>(places.size());
  if (!places.empty()) entry.design = places.front().design;
  const std::scoped_lock lock(notes_);
  if (const auto used = used_.find(record.id); used != used_.end()) entry.used_ns = used->second;
  return entry;
}

std::vector<CacheEntry> Archive::cache_entries() {
  const std::vector<StoredMesh> meshes = stored_meshes();
  const std::vector<int> depths = edits_to_make(meshes);
  std::map<std::string, int> depth;
  for (std::size_t i = 0; i < meshes.size(); ++i) depth[meshes[i].id] = depths[i];
  std::vector<CacheEntry> entries;
  for (const RevisionRecord& record :
       store_.read([](Catalogue& catalogue) { return catalogue.revisions(); }))
    entries.push_back(entry_of(record, store_.persistent() ? depth[record.id] : 0));
  return entries;
}

CacheStats Archive::cache_stats() {
  CacheStats stats{.disk_budget = disk_ != nullptr ? disk_->most() : 0,
                   .memory_bytes = held_.bytes(),
                   .memory_budget = memory_.most_held()};
  const Store::Room room = store_.room();
  stats.disk_free = room.free_bytes;
  stats.disk_bytes = store_.bytes();
  stats.quarantined = room.quarantined;
  stats.in_memory = static_cast<std::uint32_t>(held_.count());
  for (const RevisionRecord& record :
       store_.read([](Catalogue& catalogue) { return catalogue.revisions(); })) {
    stats.stored += record.bytes > 0;
    stats.pinned += record.pinned;
    const bool gone = record.bytes == 0 && !held_.contains(record.id);
    stats.outdated += gone && record.algorithm_version != engine_.algorithm_version;
  }
  stats.recipes = static_cast<std::uint32_t>(
      store_.read([](Catalogue& catalogue) { return catalogue.recipes().size(); }));
  const std::scoped_lock lock(notes_);
  stats.hits = hits_;
  stats.misses = misses_;
  stats.evictions = evictions_;
  stats.remade = remade_;
  return stats;
}

/// What came of dropping meshes one by one.
struct Archive::Dropped {
  std::uint32_t meshes = 0;
  bool full = false;  ///< one stayed: no room to rewrite the packs whose base it is
};

Collected Archive::collect_garbage(const GarbageOptions& options) {
  constexpr std::uint64_t kAny = std::numeric_limits<std::uint64_t>::max();
  // Before the lock, or there might be a deadlock: the budget calls this function under its own.
  const std::uint64_t budget =
      options.disk_bytes ? *options.disk_bytes : (disk_ != nullptr ? disk_->cap() : kAny);
  const std::scoped_lock lock(collecting_);
  Collected collected{.disk_bytes = store_.bytes()};
  if (!store_.persistent()) return collected;
  const std::uint64_t before = collected.disk_bytes;
  std::optional<std::int64_t> unused_before;
  if (options.unused_seconds)
    unused_before = nanoseconds_now() - static_cast<std::int64_t>(1e9 * *options.unused_seconds);
  if (collected.disk_bytes > budget && !options.dry_run) {
    free_removed_bases();
    collected.disk_bytes = store_.bytes();
  }
  bool full = false;  // no room to rewrite packs: a mesh that is a base cannot go now
  for (;;) {
    const std::uint64_t excess = collected.disk_bytes > budget ? collected.disk_bytes - budget : 0;
    const std::vector<StoredMesh> meshes = stored_meshes();
    const auto chosen = meshes_to_drop(meshes, full ? kAny : excess, unused_before);
    unused_before.reset();
    if (options.dry_run) {
      for (const std::string& id : chosen)
        collected.bytes_freed += std::ranges::find(meshes, id, &StoredMesh::id)->bytes;
      collected.meshes = static_cast<std::uint32_t>(chosen.size());
      collected.disk_bytes -= std::min(collected.disk_bytes, collected.bytes_freed);
      return collected;
    }
    const Dropped dropped = drop_meshes(chosen, full, budget);
    collected.meshes += dropped.meshes;
    collected.disk_bytes = store_.bytes();
    // Packs that were rewritten, as their base went, take more than before.
    if (collected.disk_bytes <= budget || (dropped.meshes == 0 && (full || !dropped.full))) break;
    full = dropped.meshes == 0;
  }
  collected.bytes_freed = before > collected.disk_bytes ? before - collected.disk_bytes : 0;
  return collected;
}

/// Drops meshes one by one. `full`: only those that are no base of others, until no more than
/// `budget` is taken.
Archive::Dropped Archive::drop_meshes(const std::vector<std::string>& ids, bool full,
                                      std::uint64_t budget) {
  Dropped dropped;
  for (const std::string& id : ids) {
    if ((full || dropped.full) &&
        !store_.read([&](Catalogue& catalogue) { return catalogue.standing_on(id).empty(); }))
      continue;
    if (full && store_.bytes() <= budget) break;
    try {
      dropped.meshes += drop_mesh(id);
    } catch (const Error& failure) {
      // It, or a pack whose base it is, cannot be read or written: it stays.
      dropped.full |= failure.info().reason == "STORE_FULL";
    }
  }
  return dropped;
}

bool Archive::drop_mesh(const std::string& id) {
  for (const std::string& other :
       store_.read([&](Catalogue& catalogue) { return catalogue.standing_on(id); }))
    stand_elsewhere(other, id);
  bool dropped = false;
  const auto drop = [&](Catalogue& catalogue) {
    const auto record = catalogue.revision(id);
    dropped = record && record->bytes > 0 && !record->pinned && !catalogue.is_base(id);
    return dropped ? Transaction{DropMesh{id}} : Transaction{};
  };
  store_.commit(drop, Store::OnFullDisk::GoOn);
  if (dropped && metrics_ != nullptr) metrics_->evicted(Metrics::Tier::Disk);
  const std::scoped_lock lock(notes_);
  evictions_ += dropped;
  return dropped;
}

void Archive::free_removed_bases() {
  std::set<std::string> failed;
  for (bool again = true; again;) {
    again = false;
    for (const auto& [id, base] : store_.on_removed_bases()) {
      if (failed.contains(id)) continue;
      try {
        stand_elsewhere(id, base);
        again = true;
      } catch (const Error&) {
        failed.insert(id);  // it cannot be read or written: it stays as it is
      }
    }
  }
}

void Archive::stand_elsewhere(const std::string& id, const std::string& from) {
  const auto turn = writing_.take(id);
  const std::string base = store_.base_of(from);
  const auto record = store_.read([&](Catalogue& catalogue) { return catalogue.revision(id); });
  if (!record || record->base != from) return;
  RevisionRecord moved = *record;
  const std::string recipe = store_.recipe(id);
  const StoredArrays arrays = store_.get(id);
  const PlaceRecord place = first_place(id);
  if (base.empty()) {
    store_.put(moved, place, recipe, arrays);
  } else {
    const StoredArrays of_base = store_.get(base);
    const Packs::Base other{base, &of_base};
    store_.put(moved, place, recipe, arrays, &other);
  }
  store_.commit([&](Catalogue& catalogue) {
    auto now = catalogue.revision(id);
    if (!now || now->bytes == 0) return Transaction{};  // it was dropped meanwhile
    now->bytes = moved.bytes;
    now->base = moved.base;
    return Transaction{AddRevision{*now}};
  });
  store_.discard(id);
}

std::optional<CacheFault> Archive::check_stored(const std::string& id) {
  if (!is_stored(id)) return std::nullopt;
  CacheFault fault{.revision = id, .what = store_.fault_of(id)};
  if (fault.what.empty() || !is_stored(id)) return std::nullopt;  // it may have gone meanwhile
  set_damaged(id, true);
  return fault;
}

CacheEntry Archive::set_pin(const std::string& text, bool pinned) {
  const std::string id = resolve(text).id;
  if (shared_) shared_->set_pin(id, pinned);
  const std::scoped_lock lock(filing_);
  store_.commit([&](Catalogue& catalogue) {
    const auto record = catalogue.revision(remeshd::resolve(catalogue, id).id);
    return record->pinned == pinned ? Transaction{} : Transaction{SetPin{id, pinned}};
  });
  const std::vector<StoredMesh> meshes = stored_meshes();
  const std::vector<int> depths = edits_to_make(meshes);
  const auto mesh = std::ranges::find(meshes, id, &StoredMesh::id);
  const int depth = depths[static_cast<std::size_t>(mesh - meshes.begin())];
  return entry_of(*store_.read([&](Catalogue& catalogue) { return catalogue.revision(id); }),
                  store_.persistent() ? depth : 0);
}

}  // namespace remeshd
