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

/// To have a mesh, so many edits are made again at most.
inline constexpr int kMostRemade = 8;

/// How many meshes have to be made again to have each: 0 where it is stored; one of which a recipe
/// is missing on the way counts as far too many. In the order of `meshes`.
std::vector<int> edits_to_make(const std::vector<StoredMesh>& meshes);

/// The meshes that go, those used longest ago first, until `bytes` are freed; with `unused_before`
/// also all that were not used since. Those that are pinned or have no recipe stay, and so does
/// whatever another one needs so that at most `kMostRemade` edits have to be made again for it.
std::vector<std::string> meshes_to_drop(std::vector<StoredMesh> meshes, std::uint64_t bytes,
                                        std::optional<std::int64_t> unused_before = std::nullopt);

}  // namespace remeshd
