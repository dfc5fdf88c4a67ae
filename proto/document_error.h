#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "engine/base/error.h"

namespace remeshd {

/// Where in a document something stands, as far as its reader can be told.
struct DocumentPlace {
  std::string feature;  ///< id; empty outside of features, or where the id itself is at fault
  std::string path;     ///< `features[3].placement.origin`, from the nearest thing that has a name
  std::optional<int> edit_index;  ///< inside an edit document
};

namespace error {

Error document_too_large(std::size_t bytes, std::size_t limit);
Error document_too_deep(int limit);
Error document_malformed(std::size_t line, std::size_t column, std::string_view what);
Error document_unreadable(std::string_view file, std::string_view why);
Error duplicate_key(std::string_view key);
Error unknown_field(const DocumentPlace& place, std::string_view field, std::string_view known);
Error missing_field(const DocumentPlace& place, std::string_view field);
/// `wanted` reads like "a number or an expression".
Error wrong_kind(const DocumentPlace& place, std::string_view wanted, std::string_view found);
/// A number that is NaN or infinite, which no JSON but any message can carry.
Error not_finite(const DocumentPlace& place);

}  // namespace error
}  // namespace remeshd
