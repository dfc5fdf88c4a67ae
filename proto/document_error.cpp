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

ErrorInfo at(const DocumentPlace& place, std::string reason) {
  ErrorInfo info;
  info.kind = ErrorKind::InvalidArgument;
  info.reason = std::move(reason);
  info.stage = "document";
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

Error document_too_large(std::size_t bytes, std::size_t limit) {
  ErrorInfo info = at({}, "DocumentTooLarge");
  info.message = "the document has " + std::to_string(bytes) + " bytes, more than the limit of " +
                 std::to_string(limit);
  info.hint = "a model document describes features, not a mesh; is this the right file?";
  return Error(std::move(info));
}

Error document_too_deep(int limit) {
  ErrorInfo info = at({}, "DocumentTooDeep");
  info.message =
      "lists and objects are nested more than " + std::to_string(limit) + " deep in the document";
  info.hint = "model and edit documents need fewer than 10 levels";
  return Error(std::move(info));
}

Error document_malformed(std::size_t line, std::size_t column, std::string_view what) {
  ErrorInfo info = at({}, "DocumentMalformed");
  info.message = "not a JSON document: line " + std::to_string(line) + ", column " +
                 std::to_string(column) + ": " + std::string(what);
  return Error(std::move(info));
}

Error document_unreadable(std::string_view file, std::string_view why) {
  ErrorInfo info = at({}, "DocumentUnreadable");
  info.message = "cannot read " + quoted(file) + ": " + std::string(why);
  return Error(std::move(info));
}

Error duplicate_key(std::string_view key) {
  ErrorInfo info = at({}, "DuplicateKey");
  info.message = "the key " + quoted(key) + " stands twice in one object";
  return Error(std::move(info));
}

Error unknown_field(const DocumentPlace& place, std::string_view field, std::string_view known) {
  ErrorInfo info = at(place, "UnknownField");
  info.message = where(place) + "unknown field " + quoted(field);
  info.hint = "known here: " + std::string(known);
  return Error(std::move(info));
}

Error missing_field(const DocumentPlace& place, std::string_view field) {
  ErrorInfo info = at(place, "MissingField");
  info.message = where(place) + "the field " + quoted(field) + " is missing";
  return Error(std::move(info));
}

Error wrong_kind(const DocumentPlace& place, std::string_view wanted, std::string_view found) {
  ErrorInfo info = at(place, "WrongKind");
  info.message = where(place) + "expected " + std::string(wanted) + ", found " + std::string(found);
  return Error(std::move(info));
}

Error not_finite(const DocumentPlace& place) {
  ErrorInfo info = at(place, "NotFinite");
  info.message = where(place) + "the number is NaN or infinite";
  return Error(std::move(info));
}

}  // namespace remeshd::error
