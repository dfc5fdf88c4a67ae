#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <unordered_set>
#include <vector>

#include "server/session/recipe.h"
#include "server/store/store.h"
#include "server/tier/outbox.h"
#include "server/tier/sharing.h"

namespace remeshd {

/// A tenant's revisions in the shared tier: `recipe/...`, the record and recipe of a revision, and
/// `pack/...`, its pack. Both are named by the revision's id, so that of two daemons that write one
/// it does not matter who is last. Whatever is read is checked in full before it is given out; what
/// is wrong is kept in the store's quarantine, taken for absent, and written over as soon as the
/// revision has been made again. For any thread.
class SharedRevisions {
 public:
  /// What the tier knows of a revision without its mesh.
  struct Known {
    RevisionRecord record;
    std::string packed_recipe;  ///< as Store::packed_recipe
    Recipe recipe;
  };
  struct Mesh {
    Known known;
    std::string pack;  ///< the file's bytes
  };

  /// `store` must be persistent and, like the objects, outlive it.
  SharedRevisions(Sharing sharing, const std::string& tenant, Store& store);

  /// Throws Error(TIER_UNAVAILABLE), as all that follow.
  [[nodiscard]] std::optional<Known> find(const std::string& id);
  /// Whether there seems to be a mesh of it; told within so many seconds.
  [[nodiscard]] bool has_mesh(const std::string& id, double within);
  /// The mesh of a revision with those that its bytes are differences to and the store has not,
  /// each after the one that it stands on, its own last. Empty where the tier has not all of them.
  [[nodiscard]] std::vector<Mesh> meshes(const std::string& id);
  /// A mesh of `meshes` is not what its recipe tells.
  void put_away(const Mesh& mesh, std::string_view why);

  /// Has the revision and its ancestors written to the tier, as far as this process has not done
  /// so: soon, or, where an edit is acknowledged in the tier, their recipes now. Throws
  /// Error(TIER_UNAVAILABLE) in that case.
  void publish(const std::string& id);
  /// Has what was wrong of a revision written over; the store has all of it now.
  void mend(const std::string& id);
  /// The same, and its mesh written where the tier has none.
  void offer(const std::string& id);
  /// Objects that are still to be written.
  [[nodiscard]] std::size_t waiting() const { return recipes_.size() + meshes_.size(); }

 private:
  [[nodiscard]] std::string key_of(const std::string& kind, const std::string& id) const;
  std::optional<std::string> read(const std::string& key);
  void refuse(const std::string& key, std::string_view object, std::string_view why);
  std::optional<Known> find_recipe(const std::string& id);
  std::optional<Mesh> mesh(const std::string& id);
  void write_recipe(const std::string& id);
  void write_mesh(const std::string& id);
  void put(const std::string& key, const std::string& content);
  bool is_wrong(const std::string& key) const;

  const Sharing sharing_;
  const std::string prefix_;  ///< of keys
  Store& store_;
  mutable std::mutex mutex_;                     ///< guards what follows
  std::unordered_set<std::uint64_t> published_;  ///< by the first digits of the id
  std::set<std::string> wrong_;                  ///< keys that are to be written over
  Outbox recipes_, meshes_;                      ///< last: they use what stands before them
};

}  // namespace remeshd
