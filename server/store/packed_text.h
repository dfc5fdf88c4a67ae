#pragma once

#include <string>
#include <string_view>

namespace remeshd {

/// Compresses a text. The same text gives the same bytes.
std::string packed(std::string_view text);
/// The reverse. Throws Error(STORE_CORRUPTED) on anything that `packed` did not give.
std::string unpacked(std::string_view bytes);

/// Bytes as letters, digits, `+` and `/`, four for every three (RFC 4648), and back: other
/// characters are an Error(STORE_CORRUPTED).
std::string base64(std::string_view bytes);
std::string from_base64(std::string_view text);

}  // namespace remeshd
