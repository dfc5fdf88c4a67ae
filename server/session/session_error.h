#pragma once

#include <cstdint>
#include <string_view>

#include "engine/base/error.h"

namespace remeshd::error {

Error revision_not_found(std::string_view reference, std::string_view hint);
Error revision_ambiguous(std::string_view prefix);
Error reference_missing(std::string_view field);
Error design_not_found(std::string_view design);
/// The revision's mesh is lost, and was made by an older algorithm: it cannot be made again as it
/// was.
Error revision_outdated(std::string_view id, std::uint32_t made_by, std::uint32_t today);
/// The revision's mesh is lost, and what its recipe gives is not that mesh.
Error not_reproducible(std::string_view id);
Error design_empty(std::string_view design);
Error design_name_invalid(std::string_view why);
Error head_protected(std::string_view design, std::uint32_t number);
/// The head is `head` (an id; empty: none) and not `expected`.
Error head_conflict(std::string_view design, std::string_view expected, std::string_view head);
/// A request lacks the field.
Error field_missing(std::string_view field, std::string_view hint);
/// A warning that the request asked to be an error.
Error warning_is_error(const Warning& warning);
Error option_invalid(std::string_view option, std::string_view why);
Error side_invalid(std::string_view side, std::string_view why);

}  // namespace remeshd::error
