#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "server/store/records.h"

namespace remeshd {

/// What the first line of a pack says of the revision whose bytes follow it, so that a catalogue
/// can be made again from the packs alone.
struct PackHead {
  int store_version = 0;  ///< of the store that the pack was written by; 0 before there was one
  RevisionRecord record;
  PlaceRecord first;     ///< where it was filed first
  std::string sha256;    ///< of the bytes that follow, 64 digits; empty before there was a version
  std::size_t size = 0;  ///< bytes of the line, its line break included
};

/// Longest first line.
inline constexpr std::size_t kMostHeadBytes = std::size_t{1} << 16;

/// The line; `store_version` and `size` do not matter.
std::string write_pack_head(const PackHead& head);

/// Reads what a file begins with. Nothing where that is no head of this or an older version.
std::optional<PackHead> read_pack_head(std::string_view start);

/// The version of the store that wrote the file, be it newer than this program; nothing where the
/// file is no pack.
std::optional<int> store_version_of(std::string_view start);

}  // namespace remeshd
