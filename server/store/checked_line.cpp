#include "server/store/checked_line.h"

#include <cstdint>

#include "proto/checksum.h"

namespace remeshd {
namespace {

constexpr std::size_t kChecksumDigits = 8;

std::string checksum_of(std::string_view text) {
  const std::uint32_t crc = crc32c(text);
  std::string bytes;
  for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes += static_cast<char>(crc >> shift & 255U);
  return to_hex(bytes);
}

}  // namespace

std::string checked_line(std::string_view text) {
  std::string line = checksum_of(text);
  line += ' ';
  line += text;
  line += '\n';
  return line;
}

std::optional<std::string_view> checked_text(std::string_view line) {
  if (line.ends_with('\n')) line.remove_suffix(1);
  if (line.size() <= kChecksumDigits || line[kChecksumDigits] != ' ') return std::nullopt;
  const std::string_view text = line.substr(kChecksumDigits + 1);
  if (line.substr(0, kChecksumDigits) != checksum_of(text)) return std::nullopt;
  return text;
}

}  // namespace remeshd
