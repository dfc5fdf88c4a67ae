#pragma once

#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "server/session/commands.h"
#include "server/session/engine.h"
#include "server/session/held_revisions.h"
#include "server/session/one_at_a_time.h"
#include "server/session/references.h"
#include "server/store/store.h"

namespace remeshd {

/// The revisions there are: those in memory before the store, and the designs that they stand in.
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
    std::uint32_t meshes_deleted = 0;  ///< of them, those that no other design has
  };

  /// `most_held`: bytes of revisions in memory. The references must outlive the archive.
  Archive(const Engine& engine, Store& store, MemoryBudget& memory, std::uint64_t most_held);

  Reference resolve(const std::string& text);
  /// The revision, read from the store if need be; null if there is none.
  /// Throws Error(`STORE_CORRUPTED`).
  HeldRevisionPtr find(const std::string& id, const Run& run);
  /// The same, for one that was resolved. Throws Error(`REVISION_NOT_FOUND`) too.
  HeldRevisionPtr get(const std::string& id, const Run& run);

  /// Throws Error: `MESH_TOO_LARGE` where a computation that needs so many bytes can never be,
  /// `MEMORY_FULL` where it cannot until revisions are deleted.
  void check_room(std::uint64_t bytes) const;
  /// Keeps a revision just made in memory, for those who ask for it before it is filed.
  void hold(HeldRevisionPtr revision) { held_.insert(std::move(revision)); }
  /// Lets go of it where it was filed nowhere.
  void drop_unfiled(const std::string& id);

  /// Enters a revision in a design: bytes on the disk first (again, if `find` met a damaged copy),
  /// then number and head at once. It keeps the number that it has in the design. Where nothing
  /// changes by it, it waits for no disk; nor does anybody wait while it writes the bytes.
  /// Post: where there is no store, the revision is in memory, whatever was dropped meanwhile.
  /// Throws what `check_filing` throws; then nothing is filed.
  Filed file(const HeldRevisionPtr& revision, const std::string& design, const HeadRule& rule,
             const std::vector<WarningCode>& fail_on = {});

  /// What filing it would throw as things stand, for one that has not been made yet: of its record,
  /// id, parent and model count.
  /// Throws Error: HEAD_CONFLICT where the rule requires another head, WARNING_IS_ERROR.
  void check_filing(const RevisionRecord& record, const std::string& design, const HeadRule& rule,
                    const std::vector<WarningCode>& fail_on);

  /// Takes a revision out of a design (out of all where it is named by its id), and deletes it once
  /// none has it. The design's head becomes its greatest number left.
  /// Throws Error(`HEAD_PROTECTED`) for a head, unless `allow_head`.
  Removed remove(const std::string& text, bool allow_head);

  /// Makes the revision the head of `design`, or where that is empty of the one that `text` names.
  /// Throws Error: NotFound, MISSING_FIELD where no design is named, HEAD_CONFLICT where the head
  /// is not `expected` (empty: any).
  HeadSet set_head(const std::string& text, const std::string& design, const std::string& expected);

  /// Takes all revisions out of a design, deletes those that no other has, and takes the design off
  /// the list. Its numbers go on where one of the same name is made later.
  /// Throws Error: DESIGN_NOT_FOUND, HEAD_CONFLICT.
  DesignRemoved remove_design(const std::string& design, const std::string& expected);

  Store& store() { return store_; }
  [[nodiscard]] const HeldRevisions& held() const { return held_; }

 private:
  struct Filing;
  Filing plan_filing(Catalogue& catalogue, const RevisionRecord& record, const std::string& design,
                     const HeadRule& rule, const std::vector<WarningCode>& fail_on) const;
  [[nodiscard]] bool is_damaged(const std::string& id) const;
  bool lacks_bytes(const std::string& id);
  RevisionRecord write(const HeldRevision& revision, const PlaceRecord& place);
  void heal(const HeldRevisionPtr& revision);
  HeldRevisionPtr load(const RevisionRecord& record, const Run& run);
  /// Takes a revision that was deleted out of memory too.
  void forget(const std::string& id);

  const Engine& engine_;
  Store& store_;
  MemoryBudget& memory_;
  HeldRevisions held_;
  std::mutex filing_;             ///< catalogue and memory change together
  OneAtATime writing_, loading_;  ///< by id
  mutable std::mutex damage_;
  std::set<std::string> damaged_;  ///< ids whose copy in the store cannot be read; under damage_
};

}  // namespace remeshd
