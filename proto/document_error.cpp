// SPDX-License-Identifier: Apache-2.0
#include "proto/document_error.h"

#include <utility>

namespace remeshd::error {
namespace {

/// Texts from a document are quoted in errors, so they must not be able to swamp one.
std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 80;
  std::size_t end = text.size();
  if (end > kLongest) {
    end = kLongest;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  }
  std::string out;
  out.reserve(end + 5);
  out.push_back('\'');
  out.append(text.substr(0, end));
  if (end < text.size()) out.append("...");
  out.push_back('\'');
  return out;
}

DocumentErrorInfo at(const DocumentPlace& place, std::string reason) {
  DocumentErrorInfo info;
  info.reason = std::move(reason);
  info.feature = place.feature;
  info.parameter = place.path;
  info.edit_index = place.edit_index;
  info.at = place.at;
  return info;
}

DocumentErrorInfo at(const TextPosition& position, std::string reason) {
  return at(DocumentPlace{.feature = "", .path = "", .at = position}, std::move(reason));
}

std::string line_of(const TextPosition& at) {
  return "line " + std::to_string(at.line) + ", column " + std::to_string(at.column);
}

std::string where(const DocumentPlace& place) {
  std::string text;
  if (place.at.line > 0) text += line_of(place.at) + ": ";
  if (place.edit_index) text += "edit " + std::to_string(*place.edit_index) + ": ";
  if (!place.feature.empty()) text += "feature " + in_quotes(place.feature) + ": ";
  if (!place.path.empty()) text += place.path + ": ";
  return text;
}

}  // namespace

DocumentError document_too_large(std::size_t bytes, std::size_t limit) {
  DocumentErrorInfo info = at(TextPosition{}, "DOCUMENT_TOO_LARGE");
  info.message = "the document has " + std::to_string(bytes) + " bytes, more than the limit of " +
                 std::to_string(limit);
  info.hint = "a model document describes features, not a mesh; is this the right file?";
  return DocumentError(std::move(info));
}

DocumentError document_too_deep(const TextPosition& position, int limit) {
  DocumentErrorInfo info = at(position, "DOCUMENT_TOO_DEEP");
  info.message = line_of(position) + ": lists and objects are nested more than " +
                 std::to_string(limit) + " deep in the document";
  info.hint = "model and edit documents need fewer than 10 levels";
  return DocumentError(std::move(info));
}

DocumentError document_malformed(const TextPosition& position, std::string_view what) {
  DocumentErrorInfo info = at(position, "DOCUMENT_MALFORMED");
  info.message = "not a JSON document: " + line_of(position) + ": " + std::string(what);
  return DocumentError(std::move(info));
}

DocumentError document_unreadable(std::string_view file, std::string_view why) {
  DocumentErrorInfo info = at(TextPosition{}, "DOCUMENT_UNREADABLE");
  info.message = "cannot read " + in_quotes(file) + ": " + std::string(why);
  return DocumentError(std::move(info));
}

DocumentError duplicate_key(const TextPosition& position, std::string_view key) {
  DocumentErrorInfo info = at(position, "DUPLICATE_KEY");
  info.message = line_of(position) + ": the key " + in_quotes(key) + " stands twice in one object";
  return DocumentError(std::move(info));
}

DocumentError unknown_field(const DocumentPlace& place, std::string_view field,
                            std::string_view known) {
  DocumentErrorInfo info = at(place, "UNKNOWN_FIELD");
  info.message = where(place) + "unknown field " + in_quotes(field);
  info.hint = "known here: " + std::string(known);
  return DocumentError(std::move(info));
}

DocumentError missing_field(const DocumentPlace& place, std::string_view field) {
  DocumentErrorInfo info = at(place, "MISSING_FIELD");
  info.message = where(place) + "the field " + in_quotes(field) + " is missing";
  return DocumentError(std::move(info));
}

DocumentError wrong_kind(const DocumentPlace& place, std::string_view wanted,
                         std::string_view found) {
  DocumentErrorInfo info = at(place, "WRONG_KIND");
  info.message = where(place) + "expected " + std::string(wanted) + ", found " + std::string(found);
  return DocumentError(std::move(info));
}

DocumentError not_finite(const DocumentPlace& place) {
  DocumentErrorInfo info = at(place, "NOT_FINITE");
  info.message = where(place) + "the number is NaN or infinite";
  return DocumentError(std::move(info));
}

DocumentError no_edits(const TextPosition& position) {
  DocumentErrorInfo info = at({.feature = "", .path = "edits", .at = position}, "NO_EDITS");
  info.message = "the list of edits is empty";
  info.hint = "give at least one edit";
  return DocumentError(std::move(info));
}

}  // namespace remeshd::error
