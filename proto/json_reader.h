// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "proto/document_error.h"

namespace remeshd {

/// What a document may be at most; beyond it, it is refused before anything is made of it.
struct DocumentLimits {
  std::size_t bytes = std::size_t{4} << 20;  ///< of text
  int depth = 40;                            ///< of lists and objects inside each other
};

/// A JSON value. Members of objects stay in the order of the text.
struct Json {
  struct Null {};
  struct Member;
  using List = std::vector<Json>;
  using Object = std::vector<Member>;
  std::variant<Null, bool, double, std::string, List, Object> value;
  TextPosition at{};  ///< of its first character
};
struct Json::Member {
  std::string name;
  TextPosition at;  ///< of the name
  Json value;
};

/// Reads one JSON value, strictly: RFC 8259 to the letter, UTF-8, no key twice in an object,
/// numbers within the range of doubles, limits kept.
///
/// Takes time and memory linear in `text`, and none of either for a text over the limit.
/// Throws DocumentError: `DOCUMENT_TOO_LARGE`, or with line and column `DOCUMENT_TOO_DEEP`,
/// `DUPLICATE_KEY`, `DOCUMENT_MALFORMED`.
Json read_json(std::string_view text, const DocumentLimits& limits = {});

/// Whether a member's name is the field's, in camelCase as the field's is, or in snake_case.
bool spells(std::string_view written, std::string_view field);

}  // namespace remeshd
