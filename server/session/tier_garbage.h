#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace remeshd {

/// A mesh or a recipe in the shared tier, with what it is of no use without.
struct SharedObject {
  std::string id;
  /// Of a mesh: the one that its bytes are differences to; of a recipe: the revision's parent.
  /// Empty: it stands alone.
  std::string needs;
  std::uint64_t bytes = 0;
  std::int64_t written_ns = 0;  ///< since 1970, UTC
  bool pinned = false;
};

/// What stays, by id: those that are pinned, then those written since `after`, the newest first,
/// each with all that it needs, as long as they have no more than `bytes` together.
std::set<std::string> kept_objects(const std::vector<SharedObject>& objects, std::uint64_t bytes,
                                   std::optional<std::int64_t> after);

/// What goes, each before what it needs, so that nothing wants for anything at any moment.
std::vector<SharedObject> dropped_objects(const std::vector<SharedObject>& objects,
                                          const std::set<std::string>& kept);

}  // namespace remeshd
