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

/// A revision and its recipe, which may be empty, in a line: what it is, whatever store has it.
std::string line_of(RevisionRecord record, const std::string& packed_recipe);
/// The same back; nothing where the line tells of no revision.
std::optional<AddRevision> revision_in(const std::string& line);

/// What a record and its recipe tell, of a revision of that id. Throws WrongObject.
SharedRecord shared_record(RevisionRecord record, std::string packed_recipe, const std::string& id);
/// The same of a line. Throws WrongObject.
SharedRecord shared_record_in(const std::string& line, const std::string& id);

}  // namespace remeshd
