#include "server/tier/sealed_object.h"

#include <openssl/crypto.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>

#include <array>
#include <nlohmann/json.hpp>

#include "proto/checksum.h"

namespace remeshd {
namespace {

using nlohmann::json;

constexpr const char* kFormat = "remeshd-object-1";

/// 64 hexadecimal digits.
std::string mac_of(std::string_view text, std::string_view farm_key) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> mac{};
  unsigned size = 0;
  HMAC(EVP_sha256(), farm_key.data(), static_cast<int>(farm_key.size()),
       reinterpret_cast<const unsigned char*>(text.data()), text.size(), mac.data(), &size);
  return to_hex({reinterpret_cast<const char*>(mac.data()), size});
}

bool same(std::string_view a, std::string_view b) {
  return a.size() == b.size() && CRYPTO_memcmp(a.data(), b.data(), a.size()) == 0;
}

}  // namespace

std::string sealed(std::string_view key, std::string_view bytes, std::string_view farm_key) {
  const std::string told = json{
      {"format", kFormat},
      {"key", key},
      {"bytes", bytes.size()},
      {"sha256",
       sha256_hex(bytes)}}.dump();
  std::string object = told + ' ' + mac_of(told, farm_key) + '\n';
  object += bytes;
  return object;
}

std::string unsealed(std::string_view key, std::string_view object, std::string_view farm_key) {
  const std::size_t end = object.substr(0, kMostSealBytes).find('\n');
  if (end == std::string_view::npos) throw WrongObject("it is no object of remeshd");
  const std::string_view line = object.substr(0, end), bytes = object.substr(end + 1);
  const std::size_t space = line.rfind(' ');
  if (space == std::string_view::npos) throw WrongObject("it is no object of remeshd");
  const std::string_view told = line.substr(0, space);
  // Checked before the text is parsed, which may be a stranger's.
  if (!same(line.substr(space + 1), mac_of(told, farm_key)))
    throw WrongObject("it was not sealed with the farm's key");
  const json content = json::parse(told, nullptr, false);
  if (!content.is_object() || content.value("format", "") != kFormat)
    throw WrongObject("it is of a format that is not known");
  if (content.value("key", "") != key) throw WrongObject("it belongs to another key");
  if (content.value("bytes", std::size_t{0}) != bytes.size())
    throw WrongObject("it is cut off or too long");
  if (content.value("sha256", "") != sha256_hex(bytes))
    throw WrongObject("it has not the digest that it tells");
  return std::string(bytes);
}

std::string_view after_seal(std::string_view start) {
  const std::size_t end = start.substr(0, kMostSealBytes).find('\n');
  return end == std::string_view::npos ? std::string_view() : start.substr(end + 1);
}

}  // namespace remeshd
