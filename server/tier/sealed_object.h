#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace remeshd {

/// Bytes under a key of a shared store that are not what a daemon of this farm wrote there.
class WrongObject : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Bytes as they stand in a shared store: a line that tells format, key and digest, with an
/// HMAC-SHA256 of it under the farm's key, then the bytes. Who has not the farm's key can neither
/// change them nor put them under another key.
std::string sealed(std::string_view key, std::string_view bytes, std::string_view farm_key);

/// The bytes. Throws WrongObject.
std::string unsealed(std::string_view key, std::string_view object, std::string_view farm_key);

/// Most bytes of a seal's line, and what follows that line at the start of an object, unchecked;
/// empty where there is no such line.
inline constexpr std::size_t kMostSealBytes = 4096;
std::string_view after_seal(std::string_view start);

}  // namespace remeshd
