#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace remeshd {

/// A text with its checksum before it, as every line stands in the store's files: CRC-32C in 8
/// lower-case hexadecimal digits, a space, the text, a line break. The text has no line break.
std::string checked_line(std::string_view text);

/// The text of a line, with or without the line break at its end; nothing where the line is not
/// what was written.
std::optional<std::string_view> checked_text(std::string_view line);
/// The text would not outlive the line.
std::optional<std::string_view> checked_text(std::string&& line) = delete;

}  // namespace remeshd
