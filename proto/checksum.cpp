// SPDX-License-Identifier: Apache-2.0
#include "proto/checksum.h"

#include <isa-l/crc.h>
#include <openssl/evp.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace remeshd {

std::uint32_t crc32c(std::string_view data, std::uint32_t crc) {
  constexpr std::size_t kMost = std::size_t{1} << 30U;  // ISA-L counts with int
  crc = ~crc;
  for (; !data.empty(); data.remove_prefix(std::min(kMost, data.size()))) {
    const std::string_view some = data.substr(0, kMost);
    // It reads alone, though its parameter does not say so.
    auto* const bytes =
        const_cast<unsigned char*>(reinterpret_cast<const unsigned char*>(some.data()));
    crc = crc32_iscsi(bytes, static_cast<int>(some.size()), crc);
  }
  return ~crc;
}

struct Sha256::Context {
  EVP_MD_CTX* evp = EVP_MD_CTX_new();
  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() { EVP_MD_CTX_free(evp); }
};

Sha256::Sha256() : context_(std::make_unique<Context>()) {
  if (context_->evp == nullptr || EVP_DigestInit_ex(context_->evp, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("OpenSSL offers no SHA-256");
}
Sha256::~Sha256() = default;
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;

void Sha256::update(std::string_view data) {
  EVP_DigestUpdate(context_->evp, data.data(), data.size());
}

std::string Sha256::finish() {
  std::string digest(32, '\0');
  EVP_DigestFinal_ex(context_->evp, reinterpret_cast<unsigned char*>(digest.data()), nullptr);
  return digest;
}

std::string to_hex(std::string_view bytes) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  text.reserve(2 * bytes.size());
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    text += kDigits[byte >> 4U];
    text += kDigits[byte & 15U];
  }
  return text;
}

std::string from_hex(std::string_view digits) {
  constexpr int kBase = 16;
  std::string bytes;
  bytes.reserve(digits.size() / 2);
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    unsigned char byte = 0;
    std::from_chars(digits.data() + i, digits.data() + i + 2, byte, kBase);
    bytes += static_cast<char>(byte);
  }
  return bytes;
}

std::string sha256_hex(std::string_view data) {
  Sha256 sum;
  sum.update(data);
  return to_hex(sum.finish());
}

}  // namespace remeshd
