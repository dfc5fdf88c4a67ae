#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace remeshd {

/// A mesh or a recipe in the shared tier, with the object that it needs.
struct SharedObject {
  std::string id;
  /// Of a mesh: the one that its bytes are differences to; of a recipe: the revision's parent.
  /// Empty: it stands alone.
  std::string needs;
  std::uint64_t bytes = 0;
  std::int64_t written_ns = 0;  ///< since 1970, UTC
  bool pinned = false;
};

/// Ids of the objects that stay: those that are pinned, then those written since `after`, the
/// newest first, each with all that it needs, as long as they have no more than `bytes` together.
std::set<std::string> kept_objects(const std::vector<SharedObject>& objects, std::uint64_t bytes,
                                   std::optional<std::int64_t> after);

/// The objects that go, each before the one that it needs, so that at no moment an object lacks
/// what it needs.
std::vector<SharedObject> dropped_objects(const std::vector<SharedObject>& objects,
                                          const std::set<std::string>& kept);

}  // namespace remeshd
