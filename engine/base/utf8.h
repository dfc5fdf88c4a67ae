#pragma once

#include <cstddef>
#include <string_view>

namespace remeshd {

/// Bytes of the UTF-8 character that begins at byte `at`; 0 where none does. Pre: `at` is within.
std::size_t utf8_length(std::string_view text, std::size_t at);

/// Whether all of a text is UTF-8.
bool is_utf8(std::string_view text);

}  // namespace remeshd
