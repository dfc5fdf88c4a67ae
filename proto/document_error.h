// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace remeshd {

/// A character of a text, from 1; 0 where it is not known: messages have no lines.
struct TextPosition {
  std::uint32_t line = 0, column = 0;
};

/// Where in a document something stands, as far as its reader can be told.
struct DocumentPlace {
  std::string feature;  ///< id; empty outside of features, or where the id itself is at fault
  std::string path;     ///< `features[3].placement.origin`, from the nearest thing that has a name
  std::optional<int> edit_index{};  ///< inside an edit document
  TextPosition at{};
};

/// What is wrong with a document, in words that its writer can act on.
struct DocumentErrorInfo {
  std::string reason{};             ///< a name of the protocol's Error.Reason: `UNKNOWN_FIELD`
  std::string message{};            ///< one sentence
  std::string feature{};            ///< id; empty where none is at fault
  std::string parameter{};          ///< the path; empty where the whole document is at fault
  std::string hint{};               ///< what would help; empty where nothing sensible can be said
  std::optional<int> edit_index{};  ///< of the edit at fault
  TextPosition at{};                ///< in the document; `message` tells it too
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
DocumentError document_too_deep(const TextPosition& at, int limit);
DocumentError document_malformed(const TextPosition& at, std::string_view what);
DocumentError document_unreadable(std::string_view file, std::string_view why);
DocumentError duplicate_key(const TextPosition& at, std::string_view key);
DocumentError unknown_field(const DocumentPlace& place, std::string_view field,
                            std::string_view known);
DocumentError missing_field(const DocumentPlace& place, std::string_view field);
/// `wanted` reads like "a number or an expression".
DocumentError wrong_kind(const DocumentPlace& place, std::string_view wanted,
                         std::string_view found);
/// A number that is NaN or infinite, which no JSON but any message can carry.
DocumentError not_finite(const DocumentPlace& place);
/// An edit without edits.
DocumentError no_edits(const TextPosition& at);

}  // namespace error
}  // namespace remeshd
