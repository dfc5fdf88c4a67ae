#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace remeshd {

/// What the numbers of an array are; little-endian, two's complement, IEEE 754.
enum class StoredType : std::uint8_t { U8 = 1, I32 = 2, U64 = 3, F64 = 4 };

/// Bytes of one number.
constexpr std::size_t bytes_of(StoredType type) {
  return type == StoredType::U8 ? 1 : type == StoredType::I32 ? 4 : 8;
}

/// An array as it is kept outside of memory: its bytes, and what they are.
struct StoredArray {
  std::string name;  ///< unique in its set: `output.nodes`
  /// Name of the array that it may be close to in a set that has none of its own name; maybe empty.
  std::string like{};
  StoredType type = StoredType::U8;
  std::uint32_t components = 1;  ///< numbers of an element
  /// The bytes in pieces of `piece_bytes`, but for the last, which may be shorter. Arrays that
  /// share memory have pieces at the same address.
  std::vector<std::string_view> pieces;
  std::size_t piece_bytes = 0;
  std::shared_ptr<const std::string> owned;  ///< what the pieces lie in, where they are a copy

  /// Takes bytes over, cut into pieces.
  void own(std::string bytes);
  [[nodiscard]] std::size_t size() const;  ///< bytes
  [[nodiscard]] std::string flat() const;
};

/// Name of the one array of a revision that was stored before there were arrays by name: its bytes.
inline constexpr const char* kOlderBytes = "older_bytes";

/// All that something is kept as. New arrays need no new format: who does not know one leaves it.
struct StoredArrays {
  std::vector<StoredArray> arrays;

  /// Null where there is none of that name.
  [[nodiscard]] const StoredArray* find(std::string_view name) const;
  [[nodiscard]] std::size_t size() const;  ///< bytes
};

}  // namespace remeshd
