#include "server/guard/tokens.h"

#include <openssl/crypto.h>
#include <openssl/evp.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "server/guard/secret_file.h"

namespace remeshd {
namespace {

bool is_tenant(std::string_view name) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '-' || c == '_';
  };
  if (name == "." || name == "..") return false;
  return !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), fits);
}

bool is_token(std::string_view token) {
  return token.size() >= 16 && token.size() <= 512 &&
         std::all_of(token.begin(), token.end(), [](char c) { return c > 0x20 && c < 0x7F; });
}

}  // namespace

Tokens::Digest Tokens::digest_of(std::string_view token) {
  Digest digest;
  if (EVP_Digest(token.data(), token.size(), digest.data(), nullptr, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("SHA-256 fails");
  return digest;
}

Tokens Tokens::read(const std::filesystem::path& file) {
  std::istringstream text(read_secret_file(file));
  Tokens out;
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    const auto fail = [&](const std::string& why) {
      return SecretFileError(file.string() + ":" + std::to_string(number) + ": " + why);
    };
    std::istringstream words(line);
    std::string tenant, token, more;
    if (!(words >> tenant) || tenant.front() == '#') continue;
    if (!(words >> token) || words >> more) throw fail("is not `TENANT TOKEN`");
    if (!is_tenant(tenant))
      throw fail(
          "a tenant's name has 1 to 64 letters, digits, `.`, `-` or `_`, and is not `.` or `..`");
    if (!is_token(token)) throw fail("a token has 16 to 512 visible characters of ASCII");
    const Digest digest = digest_of(token);
    for (const Entry& entry : out.entries_)
      if (entry.digest == digest) throw fail("the token stands in an earlier line too");
    out.entries_.push_back({digest, tenant});
  }
  if (out.entries_.empty()) throw SecretFileError(file.string() + ": has no token");
  return out;
}

std::set<std::string> Tokens::tenants() const {
  std::set<std::string> names;
  for (const Entry& entry : entries_) names.insert(entry.tenant);
  return names;
}

std::optional<std::string> Tokens::tenant_of(std::string_view token) const {
  const Digest digest = digest_of(token);
  const Entry* found = nullptr;
  for (const Entry& entry : entries_)
    if (CRYPTO_memcmp(entry.digest.data(), digest.data(), digest.size()) == 0) found = &entry;
  if (found == nullptr) return std::nullopt;
  return found->tenant;
}

}  // namespace remeshd
