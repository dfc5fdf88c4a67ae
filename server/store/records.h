#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace remeshd {

/// What is known of a revision without reading it.
struct RevisionRecord {
  std::string id;      ///< 64 hexadecimal digits
  std::string parent;  ///< id; empty for a first mesh
  std::string root;    ///< id of the first mesh of its chain; empty where that is not known
  std::string model_name;
  std::string model;                    ///< as `model_digest`; empty where that is not known
  std::uint32_t algorithm_version = 0;  ///< 0 where it is not known
  std::int64_t created_ns = 0;          ///< since 1970, UTC
  std::uint32_t nodes = 0, tets = 0;
  std::uint32_t mid_nodes = 0;  ///< 0 too where an older version stored it
  std::uint64_t bytes = 0;      ///< of its file; 0 where its mesh is not stored
  /// Id of the revision whose bytes its own are differences to; empty where they stand alone.
  std::string base;
  std::vector<double> seconds;  ///< that its making took, as its report tells them
  bool pinned = false;          ///< its mesh must not be dropped
  friend bool operator==(const RevisionRecord&, const RevisionRecord&) = default;
};

/// A revision's number in a design.
struct PlaceRecord {
  std::string design;
  std::uint32_t number = 0;
  std::string id;
  bool head = false;
  friend bool operator==(const PlaceRecord&, const PlaceRecord&) = default;
};

struct DesignRecord {
  std::string name;
  std::string head;  ///< id; empty where there is none
  std::uint32_t head_number = 0;
  std::uint32_t next_number = 1;
  std::uint32_t revisions = 0;
  std::int64_t changed_ns = 0;  ///< of its head or its list; since 1970, UTC
  friend bool operator==(const DesignRecord&, const DesignRecord&) = default;
};

/// Where a line of the journal stands in its first file.
struct JournalPlace {
  std::uint64_t start = 0;   ///< byte
  std::uint64_t length = 0;  ///< bytes, line break included
  friend bool operator==(const JournalPlace&, const JournalPlace&) = default;
};

/// A recipe, or the line of the journal that has it: recipes of long chains are too many for the
/// memory.
struct KeptRecipe {
  KeptRecipe() = default;
  KeptRecipe(std::string packed_text) : bytes(std::move(packed_text)) {}
  KeptRecipe(JournalPlace line) : place(line) {}

  std::string bytes;                  ///< as `packed`
  std::optional<JournalPlace> place;  ///< then `bytes` is empty
  [[nodiscard]] bool empty() const { return bytes.empty() && !place; }
  friend bool operator==(const KeptRecipe&, const KeptRecipe&) = default;
};

/// Where the recipe of a revision stands in the journal.
struct RecipePlace {
  std::string id;
  JournalPlace line;
};

struct AddRevision {
  RevisionRecord record;
  KeptRecipe recipe{};  ///< empty: the one that is there, if any, stays
};
/// Keeps the recipe of a revision that is no more: others have to be made of it again.
struct KeepRecipe {
  std::string id;
  std::string parent;
  KeptRecipe recipe;
};
/// The mesh goes; the revision and its recipe stay.
struct DropMesh {
  std::string id;
};
struct SetPin {
  std::string id;
  bool pinned = false;
};
/// Gives a revision a number in a design; the design's next number is at least one more from then
/// on, for good.
struct AddPlace {
  std::string design;
  std::uint32_t number = 0;
  std::string id;
};
struct SetHead {
  std::string design;
  std::string id;  ///< empty: no head
};
struct RemovePlace {
  std::string design;
  std::uint32_t number = 0;
};
struct RemoveRevision {
  std::string id;
};
/// Enters a design, or raises the next number and the time of last change of one that is there to
/// at least these.
struct AddDesign {
  std::string name;
  std::uint32_t next_number = 1;
  std::int64_t changed_ns = 0;  ///< 0: not told
  bool listed = true;           ///< false takes it off the list; its numbers stay
};
/// Forgets everything: what follows tells it anew.
struct StartAnew {};

using Operation = std::variant<AddRevision, AddPlace, SetHead, RemovePlace, RemoveRevision,
                               AddDesign, StartAnew, KeepRecipe, DropMesh, SetPin>;

/// Operations on the catalogue that happen all together or not at all.
using Transaction = std::vector<Operation>;

/// The recipe that an operation brings, and whose it is; nulls where it brings none.
struct BroughtRecipe {
  const std::string* id = nullptr;
  KeptRecipe* recipe = nullptr;
};
inline BroughtRecipe recipe_in(Operation& operation) {
  if (auto* added = std::get_if<AddRevision>(&operation);
      added != nullptr && !added->recipe.empty())
    return {&added->record.id, &added->recipe};
  if (auto* kept = std::get_if<KeepRecipe>(&operation)) return {&kept->id, &kept->recipe};
  return {};
}

}  // namespace remeshd
