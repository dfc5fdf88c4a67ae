#include "server/config/ascii_form.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <functional>
#include <system_error>

namespace remeshd {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::size_t kDigits = 2;
constexpr int kHexadecimal = 16;

bool is_ascii(char byte) { return static_cast<unsigned char>(byte) < 0x80; }

}  // namespace

AsciiForm::AsciiForm(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  // `?` begins neither a key nor a value. The number makes the mark one that does not occur in the
  // text; it starts at a hash, so that the text's escape sequences do not spell it either.
  std::uint64_t number = std::hash<std::string_view>{}(text);
  do {
    mark_ = fmt::format("?{:x}:", number++);
  } while (text.find(mark_) != std::string_view::npos);
  for (const char byte : text) {
    if (is_ascii(byte))
      text_ += byte;
    else
      text_ += fmt::format("{}{:02x}", mark_, static_cast<unsigned char>(byte));
  }
}

std::string AsciiForm::original(std::string_view part) const {
  std::string out;
  for (;;) {
    const std::size_t at = part.find(mark_);
    out += part.substr(0, at);
    if (at == std::string_view::npos) return out;
    part.remove_prefix(at + mark_.size());
    const std::string_view digits = part.substr(0, kDigits);
    unsigned byte = 0;
    // The text of an error may end within the digits.
    if (std::from_chars(digits.data(), digits.data() + digits.size(), byte, kHexadecimal).ec ==
        std::errc())
      out += static_cast<char>(byte);
    part.remove_prefix(digits.size());
  }
}

}  // namespace remeshd
