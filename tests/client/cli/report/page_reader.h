#pragma once

#include <openssl/evp.h>
#include <zlib.h>

#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace remeshd::cli {

/// Bytes as numbers.
template <class Number>
std::vector<Number> numbers(const std::string& bytes) {
  std::vector<Number> all(bytes.size() / sizeof(Number));
  if (!all.empty()) std::memcpy(all.data(), bytes.data(), all.size() * sizeof(Number));
  return all;
}

/// What a browser makes of base64 of a zlib stream.
inline std::string unpacked(const std::string& text) {
  std::string compressed(text.size() / 4 * 3, '\0');
  const int decoded = EVP_DecodeBlock(reinterpret_cast<unsigned char*>(compressed.data()),
                                      reinterpret_cast<const unsigned char*>(text.data()),
                                      static_cast<int>(text.size()));
  if (decoded < 0) throw std::runtime_error("no base64");
  std::string bytes(1 << 20, '\0');
  uLongf length = bytes.size();
  // EVP_DecodeBlock counts what stands for the padding, which zlib does not read.
  if (uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length,
                 reinterpret_cast<const Bytef*>(compressed.data()), compressed.size()) != Z_OK)
    throw std::runtime_error("no zlib stream");
  bytes.resize(length);
  return bytes;
}

/// The text of the page's element of this id.
inline std::string element_text(const std::string& page, const std::string& id) {
  const auto at = page.find("id=\"" + id + "\">");
  if (at == std::string::npos) throw std::runtime_error("no element " + id);
  const auto begin = page.find('>', at) + 1;
  return page.substr(begin, page.find("</script>", begin) - begin);
}

/// The figures in a page.
inline nlohmann::json figures_in(const std::string& page) {
  return nlohmann::json::parse(element_text(page, "figures"));
}

}  // namespace remeshd::cli
