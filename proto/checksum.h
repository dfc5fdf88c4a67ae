// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace remeshd {

/// CRC-32C (Castagnoli, RFC 3720) of `data`; in pieces, hand the result of the piece before in as
/// `crc`.
std::uint32_t crc32c(std::string_view data, std::uint32_t crc = 0);

/// SHA-256 (FIPS 180-4) of data that comes in pieces.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;

  void update(std::string_view data);
  /// The 32 bytes of the digest. Ends the sum: nothing may be called after it.
  std::string finish();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

/// 64 lower-case hexadecimal digits.
std::string sha256_hex(std::string_view data);
/// Two lower-case hexadecimal digits a byte.
std::string to_hex(std::string_view bytes);
/// Its inverse. Pre: an even number of hexadecimal digits.
std::string from_hex(std::string_view digits);

}  // namespace remeshd
