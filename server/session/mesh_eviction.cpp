#include "server/session/mesh_eviction.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace remeshd {
namespace {

constexpr int kNever = 1 << 20;

/// Meshes with their children, and how far each is from a stored one.
class Family {
 public:
  explicit Family(const std::vector<StoredMesh>& meshes)
      : meshes_(meshes), children_(meshes.size()), parent_(meshes.size(), -1) {
    std::unordered_map<std::string, int> index;
    for (std::size_t i = 0; i < meshes.size(); ++i) index[meshes[i].id] = static_cast<int>(i);
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      const auto parent = index.find(meshes[i].parent);
      if (parent == index.end()) continue;
      parent_[i] = parent->second;
      children_[static_cast<std::size_t>(parent->second)].push_back(static_cast<int>(i));
    }
  }

  [[nodiscard]] int edits_to_make(int mesh) const {
    int edits = 0;
    for (; mesh >= 0; mesh = parent_[at(mesh)]) {
      const StoredMesh& m = meshes_[at(mesh)];
      if (m.stored) return edits;
      if (!m.has_recipe || edits >= kNever) return kNever;
      ++edits;
      if (parent_[at(mesh)] < 0 && !m.parent.empty()) return kNever;
    }
    return edits;
  }
  /// Edits from a mesh down to the furthest that would have to be made through it.
  [[nodiscard]] int height(int mesh) const {
    int most = 0;
    for (const int child : children_[at(mesh)])
      if (!meshes_[at(child)].stored) most = std::max(most, 1 + height(child));
    return most;
  }
  [[nodiscard]] bool may_go(int mesh) const {
    const StoredMesh& m = meshes_[at(mesh)];
    if (!m.stored || m.pinned || !m.has_recipe) return false;
    const int parent = parent_[at(mesh)];
    if (parent < 0 && !m.parent.empty()) return false;
    const int above = parent < 0 ? 0 : edits_to_make(parent);
    return above + 1 + height(mesh) <= kMostRemade;
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  const std::vector<StoredMesh>& meshes_;
  std::vector<std::vector<int>> children_;
  std::vector<int> parent_;  ///< -1: none, or not known
};

}  // namespace

std::vector<int> edits_to_make(const std::vector<StoredMesh>& meshes) {
  const Family family(meshes);
  std::vector<int> edits;
  for (std::size_t i = 0; i < meshes.size(); ++i)
    edits.push_back(family.edits_to_make(static_cast<int>(i)));
  return edits;
}

std::vector<std::string> meshes_to_drop(std::vector<StoredMesh> meshes, std::uint64_t bytes,
                                        std::optional<std::int64_t> unused_before) {
  const Family family(meshes);  // sees below what has gone
  std::vector<int> by_use(meshes.size());
  std::iota(by_use.begin(), by_use.end(), 0);
  std::ranges::stable_sort(by_use, {},
                           [&](int i) { return meshes[static_cast<std::size_t>(i)].used_ns; });
  std::vector<std::string> gone;
  std::uint64_t freed = 0;
  for (const int i : by_use) {
    StoredMesh& mesh = meshes[static_cast<std::size_t>(i)];
    const bool unused = unused_before && mesh.used_ns < *unused_before;
    if ((freed >= bytes && !unused) || !family.may_go(i)) continue;
    mesh.stored = false;
    freed += mesh.bytes;
    gone.push_back(mesh.id);
  }
  return gone;
}

}  // namespace remeshd
