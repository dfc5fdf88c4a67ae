#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <unordered_set>
#include <vector>

#include "server/session/cache_entry.h"
#include "server/session/shared_record.h"
#include "server/session/tier_garbage.h"
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
  // Kinds of objects, with which their keys begin.
  static constexpr const char *kRecipe = "recipe", *kPack = "pack", *kPin = "pin",
                              *kDoomed = "doomed";
  struct Mesh {
    SharedRecord known;
    std::string pack;  ///< the file's bytes
  };

  /// `store` must be persistent and, like the objects, outlive it.
  SharedRevisions(Sharing sharing, const std::string& tenant, Store& store);

  /// The record and recipe of a revision, if the tier has them. Throws Error(TIER_UNAVAILABLE), as
  /// all functions that ask the tier.
  [[nodiscard]] std::optional<SharedRecord> find(const std::string& id);
  /// Whether the tier has an object for the mesh, which is not checked; `within`: as of
  /// ObjectStore::has.
  [[nodiscard]] bool has_mesh(const std::string& id, double within);
  /// The meshes that the store lacks to have that of the revision: its chain of bases, each after
  /// its own base, and the revision itself as the last. Empty where the tier does not have all of
  /// them. `stop`: as of ObjectStore::get.
  [[nodiscard]] std::vector<Mesh> meshes(const std::string& id, const std::stop_token& stop);
  /// Refuses a mesh of `meshes` that is not what its recipe tells.
  void put_away(const Mesh& mesh, std::string_view why);
  /// Refuses a mesh that was taken in before: it is written over when it has been made again.
  void distrust(const std::string& id);

  /// Has the revision and its ancestors written to the tier, as far as this process has not done
  /// so: soon, or, where an edit is acknowledged in the tier, their recipes now. Throws
  /// Error(TIER_UNAVAILABLE) in that case.
  void publish(const std::string& id);
  /// Has the refused objects of a revision written over. Pre: the store has the revision with its
  /// mesh.
  void mend(const std::string& id);
  /// The same, and its mesh written where the tier has none.
  void offer(const std::string& id);
  /// Drops meshes and, if `options` asks for it, recipes from the tier. Keeps the bases of all
  /// meshes that stay, and the recipes of the ancestors of all revisions that stay. Throws
  /// Error(TIER_UNAVAILABLE).
  Collected collect_garbage(const GarbageOptions& options);
  /// Keeps a mesh in the tier, whichever daemon collects garbage there, or no longer.
  void set_pin(const std::string& id, bool pinned);
  /// Objects that are still to be written.
  [[nodiscard]] std::size_t waiting() const { return recipes_.size() + meshes_.size(); }

 private:
  static std::uint64_t first_digits(const std::string& id);
  [[nodiscard]] std::string key_of(const std::string& kind, const std::string& id) const;
  std::optional<std::string> read(const std::string& key, const std::stop_token& stop);
  void refuse(const std::string& key, std::string_view object, std::string_view why);
  std::optional<SharedRecord> find_recipe(const std::string& id, const std::stop_token& stop);
  std::optional<Mesh> mesh(const std::string& id, const std::stop_token& stop);
  void hold_against_recipes(std::vector<Mesh>& chain, const std::stop_token& stop);
  [[nodiscard]] std::string parent_of(const std::string& id) const;
  [[nodiscard]] std::vector<std::string> waiting_ancestors(const std::string& id) const;
  void write_recipe(const std::string& id);
  void write_mesh(const std::string& id);
  void put(const std::string& key, const std::string& content);
  [[nodiscard]] std::vector<SharedObject> objects_of(const std::string& kind) const;
  [[nodiscard]] std::string base_of(const std::string& id) const;
  std::set<std::string> marked(const std::vector<SharedObject>& go, bool dry_run);
  std::vector<SharedObject> recipes_to_drop(std::vector<SharedObject> recipes,
                                            const std::set<std::string>& kept,
                                            const GarbageOptions& options);
  void remove(const std::string& kind, const std::vector<SharedObject>& objects);
  bool is_wrong(const std::string& key) const;

  const Sharing sharing_;
  const std::string prefix_;  ///< of keys
  Store& store_;
  mutable std::mutex mutex_;  ///< guards what follows
  /// First digits of the ids of revisions whose recipes the tier has or is about to get; cleared
  /// once they are older than `limits::kTierRefresh`.
  std::unordered_set<std::uint64_t> published_;
  std::chrono::steady_clock::time_point published_since_ = std::chrono::steady_clock::now();
  std::set<std::string> wrong_;  ///< keys that are to be written over
  Outbox recipes_, meshes_;      ///< last: they use what stands before them
};

}  // namespace remeshd
