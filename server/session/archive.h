#pragma once

#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "server/session/commands.h"
#include "server/session/engine.h"
#include "server/session/held_revisions.h"
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

  /// `memory` in bytes; both references must outlive the archive.
  Archive(const Engine& engine, Store& store, std::uint64_t memory);

  Reference resolve(const std::string& text);
  /// The revision, read from the store if need be; null if there is none.
  /// Throws Error(`StoreCorrupted`).
  HeldRevisionPtr find(const std::string& id, const Run& run);
  /// The same, for one that was resolved. Throws Error(`RevisionNotFound`) too.
  HeldRevisionPtr get(const std::string& id, const Run& run);

  /// Throws Error(`MemoryFull`) where no more revisions can be held.
  void check_room() const;
  /// Keeps a revision just made in memory, for those who ask for it before it is filed.
  void hold(HeldRevisionPtr revision) { held_.insert(std::move(revision)); }
  /// Lets go of it where it was filed nowhere.
  void drop_unfiled(const std::string& id);

  /// Enters a revision in a design: bytes on the disk first (again, if `find` met a damaged copy),
  /// then number and head at once. It keeps the number that it has in the design.
  /// Post: the revision is in memory too, whatever was dropped in the meantime.
  Filed file(const HeldRevisionPtr& revision, const std::string& design, const HeadRule& rule);

  /// Takes a revision out of a design (out of all where it is named by its id), and deletes it once
  /// none has it. The design's head becomes its greatest number left.
  /// Throws Error(`HeadProtected`) for a head, unless `allow_head`.
  Removed remove(const std::string& text, bool allow_head);

  Store& store() { return store_; }
  [[nodiscard]] const HeldRevisions& held() const { return held_; }

 private:
  void put(const HeldRevision& revision, Filed& filed);

  const Engine& engine_;
  Store& store_;
  HeldRevisions held_;
  std::mutex filing_;              ///< bytes, catalogue and memory change together
  std::set<std::string> damaged_;  ///< ids whose copy in the store cannot be read; under filing_
};

}  // namespace remeshd
