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

  /// Edits that have to be made for each mesh, in their order.
  [[nodiscard]] std::vector<int> edits_to_make() const {
    constexpr int kUnknown = -1;
    std::vector<int> edits(meshes_.size(), kUnknown);
    for (int i = 0; i < static_cast<int>(meshes_.size()); ++i) {
      std::vector<int> way;
      for (int mesh = i; mesh >= 0 && edits[at(mesh)] == kUnknown; mesh = parent_[at(mesh)]) {
        way.push_back(mesh);
        edits[at(mesh)] = meshes_[at(mesh)].stored ? 0 : kNever;
      }
      for (; !way.empty(); way.pop_back()) {
        const StoredMesh& mesh = meshes_[at(way.back())];
        if (!mesh.stored && mesh.has_recipe)
          edits[at(way.back())] = std::min(kNever, 1 + edits_above(way.back(), edits));
      }
    }
    return edits;
  }
  [[nodiscard]] bool may_go(int mesh) const {
    const StoredMesh& m = meshes_[at(mesh)];
    return m.stored && !m.pinned && m.has_recipe && depth(mesh) + height(mesh) <= kMostRemade;
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  /// Edits for the parent of a mesh; 0 where it has none.
  [[nodiscard]] int edits_above(int mesh, const std::vector<int>& edits) const {
    const int parent = parent_[at(mesh)];
    if (parent >= 0) return edits[at(parent)];
    return meshes_[at(mesh)].parent.empty() ? 0 : kNever;
  }
  /// Edits that have to be made for a mesh that is not stored; those beyond `kMostRemade` are not
  /// counted.
  [[nodiscard]] int depth(int mesh) const {
    for (int edits = 1; edits <= kMostRemade; ++edits) {
      if (!meshes_[at(mesh)].has_recipe) return kNever;
      const int parent = parent_[at(mesh)];
      if (parent < 0) return meshes_[at(mesh)].parent.empty() ? edits : kNever;
      if (meshes_[at(parent)].stored) return edits;
      mesh = parent;
    }
    return kNever;
  }
  /// Edits from a mesh down to its furthest descendant that would have to be made again with it;
  /// those beyond `kMostRemade` are not counted.
  [[nodiscard]] int height(int mesh) const {
    std::vector<int> generation{mesh};
    for (int edits = 0; edits <= kMostRemade; ++edits) {
      std::vector<int> next;
      for (const int parent : generation)
        for (const int child : children_[at(parent)])
          if (!meshes_[at(child)].stored) next.push_back(child);
      if (next.empty()) return edits;
      generation = std::move(next);
    }
    return kNever;
  }

  const std::vector<StoredMesh>& meshes_;
  std::vector<std::vector<int>> children_;
  std::vector<int> parent_;  ///< -1: none, or not known
};

}  // namespace

std::vector<int> edits_to_make(const std::vector<StoredMesh>& meshes) {
  return Family(meshes).edits_to_make();
}

std::vector<std::string> meshes_to_drop(std::vector<StoredMesh> meshes, std::uint64_t bytes,
                                        std::optional<std::int64_t> unused_before) {
  const Family family(meshes);  // refers to `meshes`, so it sees what the loop drops
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
