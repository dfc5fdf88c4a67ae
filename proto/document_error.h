// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace remeshd {

/// Where in a document something stands, as far as its reader can be told.
struct DocumentPlace {
  std::string feature;  ///< id; empty outside of features, or where the id itself is at fault
  std::string path;     ///< `features[3].placement.origin`, from the nearest thing that has a name
  std::optional<int> edit_index;  ///< inside an edit document
};

/// What is wrong with a document, in words that its writer can act on.
struct DocumentErrorInfo {
  std::string reason{};             ///< stable CamelCase name, e.g. `UnknownField`
  std::string message{};            ///< one sentence
  std::string feature{};            ///< id; empty where none is at fault
  std::string parameter{};          ///< the path; empty where the whole document is at fault
  std::string hint{};               ///< what would help; empty where nothing sensible can be said
  std::optional<int> edit_index{};  ///< of the edit at fault
};

/// A document, or a message that stands for one, that cannot be right whatever the state. In the
/// words of the protocol: INVALID_ARGUMENT in the stage `document`.
class DocumentError : public std::runtime_error {
 public:
  explicit DocumentError(DocumentErrorInfo info)
      : std::runtime_error(info.message), info_(std::move(info)) {}
  [[nodiscard]] const DocumentErrorInfo& info() const { return info_; }

 private:
  DocumentErrorInfo info_;
};

/// One function per failure; each returns the DocumentError to throw.
namespace error {

DocumentError document_too_large(std::size_t bytes, std::size_t limit);
DocumentError document_too_deep(int limit);
DocumentError document_malformed(std::size_t line, std::size_t column, std::string_view what);
DocumentError document_unreadable(std::string_view file, std::string_view why);
DocumentError duplicate_key(std::string_view key);
DocumentError unknown_field(const DocumentPlace& place, std::string_view field,
                            std::string_view known);
DocumentError missing_field(const DocumentPlace& place, std::string_view field);
/// `wanted` reads like "a number or an expression".
DocumentError wrong_kind(const DocumentPlace& place, std::string_view wanted,
                         std::string_view found);
/// A number that is NaN or infinite, which no JSON but any message can carry.
DocumentError not_finite(const DocumentPlace& place);

}  // namespace error
}  // namespace remeshd
