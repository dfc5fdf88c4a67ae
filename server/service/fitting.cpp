#include "server/service/fitting.h"

#include <algorithm>

namespace remeshd {
namespace {

/// Length of the UTF-8 character that begins at `at`; 0 where none does.
std::size_t character(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[at + i]); };
  const unsigned char first = byte(0);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
  if (length == 0 || at + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
  // Longer than need be, a surrogate, or beyond U+10FFFF: no UTF-8 either.
  if ((first == 0xE0 && byte(1) < 0xA0) || (first == 0xED && byte(1) > 0x9F) ||
      (first == 0xF0 && byte(1) < 0x90) || (first == 0xF4 && byte(1) > 0x8F))
    return 0;
  return length;
}

}  // namespace

std::string fitting(const std::string& text, std::size_t limit) {
  constexpr std::size_t kDots = 3;
  std::string out;
  std::size_t cut = 0;  // where the dots would go
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character(text, at);
    const std::size_t next = std::max<std::size_t>(length, 1);
    if (out.size() + next > limit) return out.substr(0, cut) + "...";
    if (length == 0) {
      out += '?';
    } else {
      out.append(text, at, length);
    }
    at += next;
    if (out.size() + kDots <= limit) cut = out.size();
  }
  return out;
}

}  // namespace remeshd
