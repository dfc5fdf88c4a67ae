#include "server/store/packed_text.h"

#include <zstd.h>

#include <array>
#include <cstdint>

#include "server/store/store_error.h"

namespace remeshd {
namespace {

constexpr int kTextLevel = 3;
constexpr std::size_t kMostTextBytes = std::size_t{1} << 30;
constexpr std::size_t kMostTextGrowth = std::size_t{1} << 15;  // zstd makes 128 KiB of four bytes
constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr int kBits = 6;  // of a digit
constexpr std::uint8_t kNoDigit = 64;

/// The value of each character as a digit.
constexpr std::array<std::uint8_t, 256> kValues = [] {
  std::array<std::uint8_t, 256> values{};
  values.fill(kNoDigit);
  for (std::size_t i = 0; i < kDigits.size(); ++i)
    values[static_cast<unsigned char>(kDigits[i])] = static_cast<std::uint8_t>(i);
  return values;
}();

}  // namespace

std::string packed(std::string_view text) {
  std::string bytes(ZSTD_compressBound(text.size()), '\0');
  const std::size_t size =
      ZSTD_compress(bytes.data(), bytes.size(), text.data(), text.size(), kTextLevel);
  if (ZSTD_isError(size)) throw error::internal("store", ZSTD_getErrorName(size));
  bytes.resize(size);
  return bytes;
}

std::string unpacked(std::string_view bytes) {
  const unsigned long long size = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN || size > kMostTextBytes ||
      size / kMostTextGrowth > bytes.size())
    throw error::store_corrupted("", "a text cannot be unpacked");
  std::string text(size, '\0');
  if (ZSTD_decompress(text.data(), text.size(), bytes.data(), bytes.size()) != size)
    throw error::store_corrupted("", "a text cannot be unpacked");
  return text;
}

std::string base64(std::string_view bytes) {
  std::string text;
  text.reserve((4 * bytes.size() + 2) / 3);
  std::uint32_t waiting = 0;
  int bits = 0;
  for (const char byte : bytes) {
    waiting = waiting << 8U | static_cast<unsigned char>(byte);
    for (bits += 8; bits >= kBits; bits -= kBits) text += kDigits[waiting >> (bits - kBits) & 63U];
  }
  if (bits > 0) text += kDigits[waiting << (kBits - bits) & 63U];
  return text;
}

std::string from_base64(std::string_view text) {
  std::string bytes;
  bytes.reserve(3 * text.size() / 4);
  std::uint32_t waiting = 0;
  int bits = 0;
  for (const char digit : text) {
    const std::uint8_t value = kValues[static_cast<unsigned char>(digit)];
    if (value == kNoDigit) throw error::store_corrupted("", "it is no base64");
    waiting = waiting << kBits | value;
    bits += kBits;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(waiting >> bits & 255U);
  }
  return bytes;
}

}  // namespace remeshd
