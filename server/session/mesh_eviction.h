#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace remeshd {

/// What decides whether a mesh may go from the disk.
struct StoredMesh {
  std::string id;
  std::string parent;  ///< id; empty for a first mesh
  bool stored = false;
  bool pinned = false;
  bool has_recipe = false;   ///< one that this program can follow
  std::int64_t used_ns = 0;  ///< last; since 1970, UTC
  std::uint64_t bytes = 0;   ///< on the disk
};

/// Most edits that may have to be made again to have a mesh.
inline constexpr int kMostRemade = 8;

/// For each of `meshes`, in their order, how many have to be made again to have it: 0 where it is
/// stored; where a recipe on the way is missing, a number far beyond `kMostRemade`.
std::vector<int> edits_to_make(const std::vector<StoredMesh>& meshes);

/// The meshes to drop, those used longest ago first, until `bytes` are freed; with `unused_before`
/// also all that were not used since. Those that are pinned or have no recipe stay, and so does
/// whatever another one needs so that at most `kMostRemade` edits have to be made again for it.
std::vector<std::string> meshes_to_drop(std::vector<StoredMesh> meshes, std::uint64_t bytes,
                                        std::optional<std::int64_t> unused_before = std::nullopt);

}  // namespace remeshd
