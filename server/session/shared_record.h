#pragma once

#include <optional>
#include <string>

#include "server/session/recipe.h"
#include "server/store/records.h"

namespace remeshd {

/// What the shared tier tells of a revision without its mesh.
struct SharedRecord {
  RevisionRecord record;
  std::string packed_recipe;  ///< as Store::packed_recipe
  Recipe recipe;
};

/// A revision's record and recipe, which may be empty, as a journal line, without what depends on
/// the store that has it: bytes, base, pin.
std::string line_of(RevisionRecord record, const std::string& packed_recipe);
/// Reads such a line; nothing where it tells of no revision.
std::optional<AddRevision> revision_in(const std::string& line);

/// A record with its recipe read. Throws WrongObject where either is not of the revision `id`, or
/// the recipe does not give that id.
SharedRecord shared_record(RevisionRecord record, std::string packed_recipe, const std::string& id);
/// The same of a line. Throws WrongObject.
SharedRecord shared_record_in(const std::string& line, const std::string& id);

}  // namespace remeshd
