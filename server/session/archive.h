#pragma once

#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "server/observe/metrics.h"
#include "server/session/background.h"
#include "server/session/cache_entry.h"
#include "server/session/commands.h"
#include "server/session/disk_budget.h"
#include "server/session/engine.h"
#include "server/session/held_revisions.h"
#include "server/session/mesh_eviction.h"
#include "server/session/one_at_a_time.h"
#include "server/session/recipe.h"
#include "server/session/references.h"
#include "server/session/shared_designs.h"
#include "server/session/shared_revisions.h"
#include "server/store/store.h"

namespace remeshd {

/// What a tenant's archive shares with those of other daemons; sharing needs a persistent store.
struct SharedParts {
  std::unique_ptr<SharedRevisions> revisions{};  ///< null: none
  std::unique_ptr<SharedDesigns> designs{};      ///< null: designs are in the store alone
  Homes homes{};                                 ///< of designs, where there is no `designs`
};

/// A tenant's revisions, in memory, in the store and in the shared tier, and the designs that they
/// are filed in.
class Archive {
 public:
  struct Removed {
    std::string id;
    std::vector<PlaceRecord> places;
    bool mesh_deleted = false;
  };
  struct HeadSet {
    DesignRecord design;   ///< afterwards
    std::string previous;  ///< id of the head before; empty if there was none
  };
  struct DesignRemoved {
    std::uint32_t revisions = 0;       ///< taken out
    std::uint32_t meshes_deleted = 0;  ///< of those revisions that no other design has
  };

  /// The references and pointers must outlive the archive. `disk`: null for no limit; `metrics`:
  /// null for none.
  Archive(const Engine& engine, Store& store, MemoryBudget& memory, DiskBudget* disk = nullptr,
          Metrics* metrics = nullptr, SharedParts shared = {});
  ~Archive();
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;

  /// Finds the revision that a client's text names, as `resolve` of references.h. For a full id
  /// that the catalogue does not have, the shared tier is asked, and a revision that it knows is
  /// entered. Throws also Error(TIER_UNAVAILABLE) where the tier cannot tell, and what
  /// `look_at_design` throws.
  Reference resolve(const std::string& text);
  /// Whether there is a shared tier.
  [[nodiscard]] bool shares() const { return shared_ != nullptr; }
  /// Whether this daemon is the home of a design.
  [[nodiscard]] bool is_home_of(const std::string& design) const {
    return homes_.elsewhere(design).empty();
  }
  /// Throws Error(DESIGN_ELSEWHERE).
  void check_home(const std::string& design) const { homes_.check(design); }
  /// To be called before designs are read or changed. Where a table of designs is shared with other
  /// daemons, these update the catalogue from it: with the design of that name; with the one that
  /// the text names, if any; with those that the revision is in; with all. Throw Error:
  /// CATALOGUE_UNAVAILABLE, DESIGN_ELSEWHERE.
  void look_at_design(const std::string& design);
  void look_at_named(const std::string& text);
  void look_at_places(const std::string& id);
  void look_at_designs();
  /// The design that a revision named by its id stands in; empty for none. Of several it is `last`,
  /// the one that the client worked on last. Throws Error: MISSING_FIELD where that is none of
  /// them; what `look_at_places` throws.
  std::string design_of(const std::string& id, const std::string& last = {});
  /// Id of the head of a design; empty where there is none. Throws what `look_at_design` throws.
  std::string head_of(const std::string& design);
  /// Takes a revision's mesh from the shared tier into the store and returns the revision; null
  /// where the tier has no valid copy. Throws Error(TIER_UNAVAILABLE) where the tier fails, or does
  /// not answer the look-up within `limits::kTierLookUp`; else what `find` throws.
  HeldRevisionPtr find_shared(const std::string& id, const Run& run);
  /// As SharedRevisions::publish, where there is a shared tier. Pre: the revision has been filed.
  void publish(const std::string& id);
  /// As SharedRevisions::waiting.
  [[nodiscard]] std::size_t tier_waiting() const { return shared_ ? shared_->waiting() : 0; }
  /// The revision, read from the store, or taken from the shared tier, if need be; null if there is
  /// none, or if its mesh has gone. Throws Error(`STORE_CORRUPTED`).
  HeldRevisionPtr find(const std::string& id, const Run& run);
  /// The same, for a revision that was resolved; null only where its mesh must be made again of its
  /// recipe, which `get` does.
  /// Throws Error: REVISION_NOT_FOUND; STORE_CORRUPTED where there is no recipe; REVISION_OUTDATED.
  HeldRevisionPtr at_hand(const std::string& id, const Run& run);
  /// The same; a mesh that has gone or is damaged is made again of its recipe, which takes as long
  /// as the first time, and stored again. So this belongs in the lane of computations; elsewhere
  /// use `Fetcher`. A mesh made again that does not have the digests of its recipe is not given
  /// out.
  /// Throws Error: REVISION_NOT_FOUND; STORE_CORRUPTED where there is no recipe; REVISION_OUTDATED,
  /// NOT_REPRODUCIBLE; what `make_revision` throws.
  HeldRevisionPtr get(const std::string& id, const Run& run);
  /// The recipe of a revision, whether its mesh is there or not. Throws Error(REVISION_NOT_FOUND),
  /// also where an older version stored the revision without one.
  Recipe recipe(const std::string& id);

  /// Throws Error: `MESH_TOO_LARGE` where the whole budget is too small for a computation of so
  /// many bytes, `MEMORY_FULL` where there is no room for it until revisions are deleted.
  void check_room(std::uint64_t bytes) const;
  /// Keeps a revision just made in memory, for those who ask for it before it is filed.
  /// Throws Error(NOT_REPRODUCIBLE) where it was there before with other digests.
  void hold(HeldRevisionPtr revision);
  /// Drops a revision from memory where the catalogue does not have it.
  void drop_unfiled(const std::string& id);

  /// Enters a revision in a design, or in none where `design` is empty: bytes on the disk first
  /// (again, if `find` met a damaged copy), then number and head at once. A revision that is in the
  /// design keeps its number there. Where nothing changes, this does not wait for the disk; no
  /// other call waits while this writes the bytes.
  /// On a full disk the catalogue in memory takes it all the same, `durable` is false, and the
  /// store gets it as soon as there is room; unless `fail_on` lists NotDurable.
  /// Post: where there is no store, the revision is in memory, whatever was dropped meanwhile.
  /// Throws what `check_filing` throws; then nothing is filed.
  Filed file(const HeldRevisionPtr& revision, const std::string& design, const HeadRule& rule,
             const std::vector<WarningCode>& fail_on = {});

  /// Throws what filing the revision would throw now. The revision need not have been made yet: of
  /// its record only id, parent and model are used.
  /// Throws Error: HEAD_CONFLICT where the rule requires another head, WARNING_IS_ERROR.
  void check_filing(const RevisionRecord& record, const std::string& design, const HeadRule& rule,
                    const std::vector<WarningCode>& fail_on);

  /// Takes a revision out of a design (out of all where it is named by its id), and deletes it once
  /// no design has it. The design's head becomes its greatest number left.
  /// Throws Error(`HEAD_PROTECTED`) for a head, unless `allow_head`.
  Removed remove(const std::string& text, bool allow_head);

  /// Makes the revision that `text` names the head of `design`, or where that is empty of the
  /// design in `text`. Throws Error: NotFound, MISSING_FIELD where no design is named,
  /// HEAD_CONFLICT where the head is not `expected` (empty: any).
  HeadSet set_head(const std::string& text, const std::string& design, const std::string& expected);

  /// Takes all revisions out of a design, deletes those that no other has, and takes the design off
  /// the list. Its numbers go on where one of the same name is made later.
  /// Throws Error: DESIGN_NOT_FOUND, HEAD_CONFLICT.
  DesignRemoved remove_design(const std::string& design, const std::string& expected);

  /// Where the mesh of each revision is, and what it takes; by id.
  std::vector<CacheEntry> cache_entries();
  CacheStats cache_stats();
  /// Drops stored meshes, as `meshes_to_drop` chooses, until they take no more than asked for, or
  /// by default than the disk budget allows this tenant.
  Collected collect_garbage(const GarbageOptions& options);
  /// The same in the shared tier, which has no budget of its own. Throws
  /// Error(OPTIONS_INVALID) where there is none.
  Collected collect_tier_garbage(const GarbageOptions& options);
  /// Reads the stored mesh of a revision; returns what is wrong with it, if anything. A damaged one
  /// is noted, so that it is stored again when the revision is filed next.
  std::optional<CacheFault> check_stored(const std::string& id);
  /// Stores the mesh of a revision that the catalogue has, where it is damaged or has gone; returns
  /// whether it is whole now.
  bool store_again(const HeldRevisionPtr& revision);
  /// Keeps a mesh from being dropped, here and in the shared tier, or no longer.
  CacheEntry set_pin(const std::string& text, bool pinned);

  /// Whether a revision survives the end of the process.
  [[nodiscard]] bool is_durable(const std::string& id) const;
  Store& store() { return store_; }
  [[nodiscard]] const HeldRevisions& held() const { return held_; }

 private:
  /// The changes of the catalogue that file a revision, and the result for the revision.
  struct Filing {
    Filed filed;
    bool add = false;  ///< the catalogue does not have the revision
    Transaction changes;
  };
  Filing plan_filing(Catalogue& catalogue, const RevisionRecord& record, const std::string& design,
                     const HeadRule& rule, const std::vector<WarningCode>& fail_on) const;
  bool commit_designs(const SharedDesigns::Make& make, Store::OnFullDisk on_full_disk);
  Filed file_with_others(const HeldRevisionPtr& revision, const std::string& design,
                         const HeadRule& rule, const std::vector<WarningCode>& fail_on);
  void count(Metrics::CacheResult where) const;
  void count_use(const std::string& id, bool hit);
  HeldRevisionPtr look_up(const std::string& id, const Run& run);
  /// The revision, if it is at hand; where its mesh is damaged, the error that told so.
  struct Reading {
    HeldRevisionPtr held;
    std::exception_ptr damage;
  };
  Reading read(const std::string& id, const Run& run);
  /// The recipe in the store; for a revision that is known from its design alone, that in the
  /// shared tier. Empty: there is none.
  std::string recipe_text(const std::string& id);
  /// The recipe to make a mesh again of, if there is one. Throws Error(REVISION_OUTDATED) for a
  /// recipe of another algorithm version.
  std::optional<Recipe> recipe_to_follow(const std::string& id);
  HeldRevisionPtr load(const RevisionRecord& record, const Run& run);
  /// Null where there is neither a mesh nor a recipe.
  HeldRevisionPtr obtain(const std::string& id, const Run& run);
  /// Makes a mesh again of its recipe. `parent`: null for a first mesh. Pre: the caller has its
  /// turn of `remaking_`.
  HeldRevisionPtr remake(const std::string& id, const HeldRevisionPtr& parent, const Run& run);
  /// Stores the mesh of a revision that the catalogue has, where it is damaged or has gone.
  void keep(const HeldRevisionPtr& revision);

  /// Looks in the shared tier for a mesh that the store does not have; null where the tier does not
  /// tell at once that it has it, so that it has to be made again of its recipe. Pre: as of
  /// `bring`.
  HeldRevisionPtr look_up_shared(const std::string& id, const Run& run);
  /// Enters a revision that the shared tier knows.
  void adopt(const std::string& id);
  /// Takes a mesh from the shared tier into the store and memory; null where the tier has none that
  /// is right. Pre: the caller has its turn of `loading_`.
  HeldRevisionPtr bring(const std::string& id, const Run& run);
  void take_in(const SharedRevisions::Mesh& mesh);
  /// Checks a mesh against the digests of its recipe, each time that it is read: where there is a
  /// shared tier, it may have come from another daemon. Throws Error(STORE_CORRUPTED).
  void check_digests(const HeldRevision& held);

  struct Written;
  Written write(const HeldRevision& revision, const PlaceRecord& place, bool by_itself);
  /// The same; on a full disk nothing is written, and the record's `bytes` are 0.
  Written write_if_there_is_room(const HeldRevision& revision, const PlaceRecord& place);
  /// Throws Error(NOT_REPRODUCIBLE) where a recipe tells other digests.
  void check_reproduced(const HeldRevision& revision);

  [[nodiscard]] bool is_damaged(const std::string& id) const;
  void set_damaged(const std::string& id, bool damaged);
  bool is_known(const std::string& id);
  bool is_stored(const std::string& id);
  PlaceRecord first_place(const std::string& id);
  void note_use(const std::string& id);
  /// Notes whether the catalogue has a revision that is not on the disk.
  void set_unsaved(const std::string& id, bool unsaved);
  /// Stores what a full disk did not take, and finds out whether a store that failed works again.
  /// Returns false; throws where it has to be tried again.
  bool recover();

  CacheEntry entry_of(const RevisionRecord& record, int depth);
  std::vector<StoredMesh> stored_meshes();
  struct Dropped;
  Dropped drop_meshes(const std::vector<std::string>& ids, bool full, std::uint64_t budget);
  /// Drops a stored mesh, after rewriting the packs whose base it is; false where it has to stay.
  /// Throws what `stand_elsewhere` throws.
  bool drop_mesh(const std::string& id);
  /// Rewrites packs whose base is the pack of a removed revision or dropped mesh that no other pack
  /// needs, so that the base can be deleted.
  void free_removed_bases();
  /// Rewrites the pack of `id`, whose base is `from`, against the base of `from`, or without a base
  /// if `from` has none. Does nothing if `from` is not its base any more.
  void stand_elsewhere(const std::string& id, const std::string& from);
  /// Removes a deleted revision from memory, with all notes on it, unless it was filed again
  /// meanwhile.
  void forget(const std::string& id);

  const Engine& engine_;
  Store& store_;
  const std::unique_ptr<SharedRevisions> shared_;  ///< null: none
  const std::unique_ptr<SharedDesigns> designs_;   ///< null: designs are in the store alone
  const Homes homes_;
  MemoryBudget& memory_;
  Metrics* const metrics_;  ///< null: none
  HeldRevisions held_;
  std::mutex filing_;                        ///< held while catalogue and memory change together
  OneAtATime writing_, loading_, remaking_;  ///< by id
  std::mutex collecting_;
  DiskBudget* const disk_;  ///< null: no limit, or nothing is on a disk
  DiskBudget::HolderId disk_holder_ = 0;

  mutable std::mutex notes_;                  ///< guards what follows
  std::set<std::string> damaged_;             ///< ids whose copy in the store cannot be read
  std::set<std::string> unsaved_;             ///< ids that the disk had no room for
  std::map<std::string, std::int64_t> used_;  ///< last use by this process, ns since 1970
  std::uint64_t hits_ = 0, misses_ = 0, evictions_ = 0, remade_ = 0;

  Background saver_;  ///< last: it uses what stands before it
};

}  // namespace remeshd
