#pragma once

#include <optional>
#include <string>

#include "server/store/catalogue.h"

namespace remeshd {

/// A revision found by what a client calls it.
struct Reference {
  std::string id;
  std::string design;        ///< empty where it was named by its id
  std::uint32_t number = 0;  ///< in `design`
};

/// Finds the revision meant by `design` (its head), `design@number`, an id or a unique prefix of
/// one of at least 8 digits, in this order. Throws Error: NotFound, or InvalidArgument for an
/// ambiguous prefix.
Reference resolve(Catalogue& catalogue, const std::string& text);

/// The design that a text would name, be there one or not; nothing for what looks like an id.
std::optional<std::string> design_named_by(const std::string& text);

/// Throws Error(InvalidArgument, `DESIGN_NAME_INVALID`), also for what looks like an id.
void check_design_name(const std::string& name);

}  // namespace remeshd
