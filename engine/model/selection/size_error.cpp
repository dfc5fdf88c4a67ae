#include "engine/model/selection/size_error.h"

#include <string>
#include <utility>

namespace remeshd::error {
namespace {

constexpr std::size_t kLongest = 120;  // of a text of the client's in a message

std::string quoted(std::string_view text) {
  if (text.size() <= kLongest) return "'" + std::string(text) + "'";
  std::size_t end = kLongest;
  // Never cut through a UTF-8 sequence.
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return "'" + std::string(text.substr(0, end)) + "...'";
}

Error size_error(std::string reason, std::string parameter, std::string message, std::string hint) {
  return Error({.kind = ErrorKind::InvalidArgument,
                .reason = std::move(reason),
                .message = std::move(message),
                .stage = "model",
                .parameter = std::move(parameter),
                .hint = std::move(hint)});
}

std::string place_of(std::string_view size) {
  return "sizes." + std::string(size.substr(0, kLongest));
}

}  // namespace

Error selector_invalid(std::string_view parameter, std::string_view selector,
                       std::string_view why) {
  return size_error(
      "SELECTOR_INVALID", std::string(parameter),
      "the selector " + quoted(selector) + " of " + std::string(parameter) + " " + std::string(why),
      "write names of faces or ids of features, with * for any characters, ? for any "
      "one, | between them, and behind & where of them: hole*.wall | plate.top & z > 10");
}

Error selector_empty(std::string_view size) {
  return size_error("SELECTOR_EMPTY", place_of(size) + ".on",
                    "the size " + quoted(size) + " selects no face of the model's boundary",
                    "mend the selector, or remove the size");
}

Error duplicate_size(std::string_view size) {
  return size_error("DUPLICATE_NAME", place_of(size) + ".id",
                    "there is more than one size " + quoted(size),
                    "give every size an id of its own");
}

Error incomplete_size(std::string_view size, std::string_view field) {
  return size_error("MISSING_FIELD", place_of(size) + "." + std::string(field),
                    "the new size " + quoted(size) + " lacks " + quoted(field),
                    "a size that the model does not have yet needs `on` or `in`, and `size`");
}

Error unknown_size(std::string_view size) {
  Error unknown = size_error("UNKNOWN_SIZE", place_of(size),
                             "the model has no size " + quoted(size), "ids are case-sensitive");
  unknown.info().kind = ErrorKind::NotFound;
  return unknown;
}

}  // namespace remeshd::error
