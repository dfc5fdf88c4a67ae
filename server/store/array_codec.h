#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/stored_array.h"

namespace remeshd {

/// How the bytes of an array are written.
enum class ArrayEncoding : std::uint8_t {
  Full = 1,   ///< by themselves
  Pages = 2,  ///< the pieces that differ from those of a base, most of them as their difference
  Patch = 3,  ///< what a match of all bytes against all those of a base leaves, where rows moved
};

/// A page may be a difference to a difference, and so on, this deep; then it is written whole.
inline constexpr std::uint8_t kMostDepth = 8;

/// An array as it is written to a pack.
struct EncodedArray {
  std::string name;
  std::string base;  ///< name of the base's array that it is encoded against
  StoredType type = StoredType::U8;
  std::uint32_t components = 1;
  std::uint64_t bytes = 0;        ///< decoded
  std::uint64_t piece_bytes = 0;  ///< of the pages
  ArrayEncoding encoding = ArrayEncoding::Full;
  std::uint64_t data_bytes = 0;
  std::string data{};  ///< compressed
};

/// Of each page of an array, how many differences have to be added up to have it.
using PageDepths = std::vector<std::uint8_t>;

/// An array that was decoded, or is to be encoded, and what the next difference to it needs.
struct DecodedArray {
  StoredArray array;
  PageDepths depths;
};

/// Encodes an array, against `base` where there is one of the same type: what costs fewer bytes.
/// `depths` gets those of the array once written.
EncodedArray encode(const StoredArray& array, const DecodedArray* base, PageDepths& depths);

/// The reverse, with the same base, or none where the encoding is Full.
/// Throws Error(StoreCorrupted) on data that are not what `encode` makes.
DecodedArray decode(const EncodedArray& encoded, const DecodedArray* base);

/// 32 hexadecimal digits of XXH3, 128 bits: tells whether arrays are what was written, names and
/// types included; no defence against somebody who wants two of the same.
std::string content_hash(const StoredArrays& arrays);
std::string content_hash(std::string_view bytes);

}  // namespace remeshd
