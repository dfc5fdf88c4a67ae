#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/stored_array.h"

namespace remeshd {

/// How the bytes of an array are written.
enum class ArrayEncoding : std::uint8_t {
  Full = 1,   ///< without a base
  Pages = 2,  ///< only the pages that differ from the base's, most of them as XOR with those
  Patch = 3,  ///< compressed with all bytes of the base as a dictionary, for rows that moved
};

/// Longest chain of differences of a page; beyond it the page is written whole.
inline constexpr std::uint8_t kMostDepth = 8;

/// An array as it is written to a pack.
struct EncodedArray {
  std::string name;
  std::string base;  ///< name of the base's array that it is encoded against; empty: none
  StoredType type = StoredType::U8;
  std::uint32_t components = 1;
  std::uint64_t bytes = 0;        ///< decoded
  std::uint64_t piece_bytes = 0;  ///< of a page; the last may be shorter
  ArrayEncoding encoding = ArrayEncoding::Full;
  std::uint64_t data_bytes = 0;
  std::string data{};  ///< compressed
};

/// For each page of an array, the length of its chain of differences.
using PageDepths = std::vector<std::uint8_t>;

/// An array with the depths of its pages, which encoding another one against it needs.
struct DecodedArray {
  StoredArray array;
  PageDepths depths;
};

/// Encodes an array, against `base` where that is not null and of the same type, components and
/// page size, by the encoding that should take the fewest bytes. `depths` gets those of the encoded
/// array.
EncodedArray encode(const StoredArray& array, const DecodedArray* base, PageDepths& depths);

/// The reverse, with the same base, or none where the encoding is Full.
/// Throws Error(STORE_CORRUPTED) on data that are not what `encode` makes.
DecodedArray decode(const EncodedArray& encoded, const DecodedArray* base);

/// XXH3 of 128 bits, as 32 hexadecimal digits; of arrays their names and types are included.
/// Detects damage, but is no cryptographic hash.
std::string content_hash(const StoredArrays& arrays);
std::string content_hash(std::string_view bytes);

}  // namespace remeshd
