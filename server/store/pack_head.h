#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/store/array_codec.h"
#include "server/store/records.h"

namespace remeshd {

/// The first line of a pack: what a catalogue has to know of its revision, so that one can be made
/// again from the packs alone, and how to read the arrays whose data follow.
struct PackHead {
  int store_version = 0;  ///< of the store that the pack was written by; 0 before there was one
  RevisionRecord record;  ///< without `created_ns`, `seconds`, `bytes`, `pinned`
  PlaceRecord first;      ///< where it was filed first; no design: nowhere
  /// Content of the pack of `record.base`, which the arrays are encoded against.
  std::string base_content;
  std::uint32_t chain = 1;           ///< packs to be read to have the arrays, this one included
  std::uint64_t chain_bytes = 0;     ///< of the data of those that are encoded against a base
  std::uint64_t full_bytes = 0;      ///< of the data of the one that is not
  std::vector<EncodedArray> arrays;  ///< without their data, in the order in which these follow
  std::string recipe;                ///< as `packed`, right behind the line; may be empty
  std::string content;               ///< content_hash of the decoded arrays
  /// Hash of all that follows the line: content_hash, and SHA-256 up to store version 1.
  std::string data;
  std::size_t size = 0;         ///< bytes of the line, its line break included
  std::size_t recipe_size = 0;  ///< bytes of the recipe, read or not
};

/// Longest first line.
inline constexpr std::size_t kMostHeadBytes = std::size_t{1} << 16;

/// The line and the recipe; `store_version` and `size` do not matter.
std::string write_pack_head(const PackHead& head);

/// How many bytes from its beginning a file has to be read for line and recipe; nothing where that
/// cannot be told.
std::optional<std::size_t> size_of_pack_head(std::string_view start);

/// Reads the head that a file begins with; without a recipe where that is cut off or damaged.
/// Nothing where there is no head of this or an older version. Up to store version 1 the bytes of a
/// revision follow in one piece: there are no arrays then.
std::optional<PackHead> read_pack_head(std::string_view start);

/// The version of the store that wrote the file, be it newer than this program; nothing where the
/// file is no pack.
std::optional<int> store_version_of(std::string_view start);

}  // namespace remeshd
