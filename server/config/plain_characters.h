#pragma once

#include <string>
#include <string_view>

namespace remeshd {

/// Refuses a TOML text with a character that is not ASCII outside of strings and comments, where
/// TOML has none: toml++ 3.3 goes wrong at some of them (U+FC66 to U+FEFE) instead of refusing
/// them. A mark of the byte order may stand at the beginning.
///
/// Throws ConfigError with `name` and the line.
void check_plain_characters(std::string_view text, const std::string& name);

}  // namespace remeshd
