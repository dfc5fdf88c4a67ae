#include "server/session/shared_record.h"

#include <utility>
#include <variant>

#include "engine/base/error.h"
#include "server/session/revision_id.h"
#include "server/store/journal_line.h"
#include "server/store/packed_text.h"
#include "server/tier/sealed_object.h"

namespace remeshd {

std::string line_of(RevisionRecord record, const std::string& packed_recipe) {
  record.bytes = 0;
  record.base.clear();
  record.pinned = false;
  return write_journal_line({.transaction = {AddRevision{std::move(record), packed_recipe}}});
}

std::optional<AddRevision> revision_in(const std::string& line) {
  auto read = read_journal_line(line);
  auto* added = read && read->transaction.size() == 1
                    ? std::get_if<AddRevision>(&read->transaction.front())
                    : nullptr;
  if (added == nullptr) return std::nullopt;
  return std::move(*added);
}

SharedRecord shared_record(RevisionRecord record, std::string packed_recipe,
                           const std::string& id) {
  SharedRecord told{.record = std::move(record), .packed_recipe = std::move(packed_recipe)};
  try {
    told.recipe = read_recipe(unpacked(told.packed_recipe));
  } catch (const Error& why) {
    throw WrongObject("its recipe cannot be read: " + why.info().message);
  }
  const Recipe& recipe = told.recipe;
  if (told.record.id != id || recipe.revision != id || told.record.parent != recipe.parent)
    throw WrongObject("it tells of another revision");
  if (revision_id(recipe.model, recipe.options, recipe.parent, recipe.algorithm_version) != id)
    throw WrongObject("its recipe gives another revision");
  return told;
}

SharedRecord shared_record_in(const std::string& line, const std::string& id) {
  auto added = revision_in(line);
  if (!added) throw WrongObject("it tells of no revision");
  return shared_record(std::move(added->record), std::move(added->recipe.bytes), id);
}

}  // namespace remeshd
