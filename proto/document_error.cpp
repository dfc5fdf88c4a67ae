// SPDX-License-Identifier: Apache-2.0
#include "proto/document_error.h"

#include <utility>

namespace remeshd::error {
namespace {

/// Texts from a document are quoted in errors, so they must not be able to swamp one.
std::string quoted(std::string_view text) {
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
  return info;
}

std::string where(const DocumentPlace& place) {
  std::string text;
  if (place.edit_index) text += "edit " + std::to_string(*place.edit_index) + ": ";
  if (!place.feature.empty()) text += "feature " + quoted(place.feature) + ": ";
  if (!place.path.empty()) text += place.path + ": ";
  return text;
}

}  // namespace

DocumentError document_too_large(std::size_t bytes, std::size_t limit) {
  DocumentErrorInfo info = at({}, "DocumentTooLarge");
  info.message = "the document has " + std::to_string(bytes) + " bytes, more than the limit of " +
                 std::to_string(limit);
  info.hint = "a model document describes features, not a mesh; is this the right file?";
  return DocumentError(std::move(info));
}

DocumentError document_too_deep(int limit) {
  DocumentErrorInfo info = at({}, "DocumentTooDeep");
  info.message =
      "lists and objects are nested more than " + std::to_string(limit) + " deep in the document";
  info.hint = "model and edit documents need fewer than 10 levels";
  return DocumentError(std::move(info));
}

DocumentError document_malformed(std::size_t line, std::size_t column, std::string_view what) {
  DocumentErrorInfo info = at({}, "DocumentMalformed");
  info.message = "not a JSON document: line " + std::to_string(line) + ", column " +
                 std::to_string(column) + ": " + std::string(what);
  return DocumentError(std::move(info));
}

DocumentError document_unreadable(std::string_view file, std::string_view why) {
  DocumentErrorInfo info = at({}, "DocumentUnreadable");
  info.message = "cannot read " + quoted(file) + ": " + std::string(why);
  return DocumentError(std::move(info));
}

DocumentError duplicate_key(std::string_view key) {
  DocumentErrorInfo info = at({}, "DuplicateKey");
  info.message = "the key " + quoted(key) + " stands twice in one object";
  return DocumentError(std::move(info));
}

DocumentError unknown_field(const DocumentPlace& place, std::string_view field,
                            std::string_view known) {
  DocumentErrorInfo info = at(place, "UnknownField");
  info.message = where(place) + "unknown field " + quoted(field);
  info.hint = "known here: " + std::string(known);
  return DocumentError(std::move(info));
}

DocumentError missing_field(const DocumentPlace& place, std::string_view field) {
  DocumentErrorInfo info = at(place, "MissingField");
  info.message = where(place) + "the field " + quoted(field) + " is missing";
  return DocumentError(std::move(info));
}

DocumentError wrong_kind(const DocumentPlace& place, std::string_view wanted,
                         std::string_view found) {
  DocumentErrorInfo info = at(place, "WrongKind");
  info.message = where(place) + "expected " + std::string(wanted) + ", found " + std::string(found);
  return DocumentError(std::move(info));
}

DocumentError not_finite(const DocumentPlace& place) {
  DocumentErrorInfo info = at(place, "NotFinite");
  info.message = where(place) + "the number is NaN or infinite";
  return DocumentError(std::move(info));
}

}  // namespace remeshd::error
