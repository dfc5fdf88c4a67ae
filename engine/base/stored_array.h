#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace remeshd {

/// The type of the numbers of an array; little-endian, two's complement, IEEE 754.
enum class StoredType : std::uint8_t { U8 = 1, I32 = 2, U64 = 3, F64 = 4 };

/// Bytes of one number.
constexpr std::size_t bytes_of(StoredType type) {
  return type == StoredType::U8 ? 1 : type == StoredType::I32 ? 4 : 8;
}

/// An array as it is stored: its bytes, and how to read them.
struct StoredArray {
  std::string name;  ///< unique in its set: `output.nodes`
  /// Name of the array that this one is compared with where the parent's arrays have none of its
  /// own name; may be empty.
  std::string like{};
  StoredType type = StoredType::U8;
  std::uint32_t components = 1;  ///< numbers of an element
  /// The bytes, in pieces of `piece_bytes`; the last may be shorter. Arrays that share memory have
  /// pieces at the same address.
  std::vector<std::string_view> pieces;
  std::size_t piece_bytes = 0;
  std::shared_ptr<const std::string> owned;  ///< memory of the pieces, where they are a copy

  /// Takes over bytes and cuts them into pieces; of about 4 KB where `piece_bytes` is 0.
  void own(std::string bytes);
  [[nodiscard]] std::size_t size() const;  ///< bytes
  [[nodiscard]] std::string flat() const;
};

/// Name of the only array of a revision that was stored before arrays had names: all its bytes.
inline constexpr const char* kOlderBytes = "older_bytes";

/// All arrays that an object is stored as. New arrays need no new format: a reader skips names that
/// it does not know.
struct StoredArrays {
  std::vector<StoredArray> arrays;

  /// Null where there is none of that name.
  [[nodiscard]] const StoredArray* find(std::string_view name) const;
  [[nodiscard]] std::size_t size() const;  ///< bytes
};

}  // namespace remeshd
