#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace remeshd {

/// Bearer tokens, and the tenant of each.
class Tokens {
 public:
  /// Reads lines `TENANT TOKEN`; empty ones and those that begin with `#` are passed over. A tenant
  /// may have several tokens, so that one can be replaced without a gap. A tenant's name has 1 to
  /// 64 letters, digits, `.`, `-`, `_`, and names a folder: `.` and `..` are none. A token has 16
  /// to 512 visible characters of ASCII.
  ///
  /// Throws SecretFileError with the number of the line: what read_secret_file throws, another
  /// form, a token twice, no token at all.
  static Tokens read(const std::filesystem::path& file);

  /// The tenant of a token; none where it is not known. Runs in constant time: the duration does
  /// not tell how much of a wrong token is right.
  [[nodiscard]] std::optional<std::string> tenant_of(std::string_view token) const;
  /// All of them, in the order of their names.
  [[nodiscard]] std::set<std::string> tenants() const;

 private:
  using Digest = std::array<std::uint8_t, 32>;
  struct Entry {
    Digest digest;  ///< SHA-256 of the token
    std::string tenant;
  };
  static Digest digest_of(std::string_view token);

  std::vector<Entry> entries_;
};

}  // namespace remeshd
