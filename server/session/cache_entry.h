#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "server/store/records.h"

namespace remeshd {

/// Where a revision's mesh is.
enum class MeshState : std::uint8_t {
  Stored,    ///< in the store
  Memory,    ///< in memory alone
  Recipe,    ///< gone, and made again when it is asked for
  Outdated,  ///< gone, and of an older algorithm
};

struct CacheEntry {
  RevisionRecord record;
  MeshState state = MeshState::Stored;
  std::uint64_t memory_bytes = 0;  ///< that it shares with no other; 0 where it is not in memory
  int depth = 0;                   ///< edits that have to be made again to have it
  std::uint32_t places = 0;        ///< in designs
  std::string design;              ///< of the first place; empty for none
  std::int64_t used_ns = 0;        ///< last; since 1970, UTC
};

struct CacheStats {
  std::uint32_t stored = 0, in_memory = 0, recipes = 0, outdated = 0, pinned = 0;
  std::uint32_t quarantined = 0;  ///< files
  std::uint64_t disk_free = 0;    ///< of the file system
  std::uint64_t disk_bytes = 0, disk_budget = 0, memory_bytes = 0, memory_budget = 0;
  // Since the start.
  std::uint64_t hits = 0, misses = 0, evictions = 0, remade = 0;
};

struct GarbageOptions {
  std::optional<std::uint64_t> disk_bytes;  ///< at most afterwards; else the archive's budget
  std::optional<double> unused_seconds;     ///< also lets go what was not used for so long
  bool dry_run = false;
  std::optional<double> recipes_unused_seconds;  ///< s; drops recipes of the shared tier that are
                                                 ///< older and not needed
};

struct Collected {
  std::uint32_t meshes = 0;
  std::uint64_t bytes_freed = 0;
  std::uint64_t disk_bytes = 0;  ///< afterwards
  std::uint32_t recipes = 0;     ///< of the shared tier
};

struct CacheFault {
  std::string revision;  ///< id
  std::string what;      ///< one sentence
  bool repaired = false;
};

}  // namespace remeshd
