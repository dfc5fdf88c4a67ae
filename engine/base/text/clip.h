#pragma once

#include <string>
#include <string_view>

namespace remeshd {

/// Text that comes from a client and may be of any length, at most `limit` bytes of it for people
/// to read. No UTF-8 sequence is cut through.
inline std::string clip(std::string_view text, std::size_t limit = 120) {
  if (text.size() <= limit) return std::string(text);
  std::size_t end = limit;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return std::string(text.substr(0, end)) + "...";
}

inline std::string quoted(std::string_view text) { return "'" + clip(text) + "'"; }

}  // namespace remeshd
