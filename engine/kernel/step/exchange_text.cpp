#include "engine/kernel/step/exchange_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstdio>

#include "engine/base/utf8.h"

namespace remeshd::kernel {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// The code point of a UTF-8 character. Pre: it is one.
std::uint32_t code_point(std::string_view character) {
  const auto first = static_cast<unsigned char>(character.front());
  if (character.size() == 1) return first;
  std::uint32_t code = first & (0x7FU >> character.size());
  for (const char c : character.substr(1))
    code = (code << 6U) | (static_cast<unsigned char>(c) & 0x3FU);
  return code;
}

void append_encoded(std::string& out, std::uint32_t code) {
  std::array<char, 24> text{};
  const bool wide = code > 0xFFFF;
  std::snprintf(text.data(), text.size(), wide ? "\\X4\\%08X\\X0\\" : "\\X2\\%04X\\X0\\", code);
  out += text.data();
}

/// A string with its quotes, encoded; control characters and bytes that are no UTF-8 become
/// question marks.
std::string encoded(const std::string& string) {
  std::string out;
  for (std::size_t at = 0; at < string.size();) {
    const std::size_t length = utf8_length(string, at);
    const auto first = static_cast<unsigned char>(string[at]);
    if (length == 0 || first < 0x20 || first == 0x7F)
      out += '?';
    else if (length == 1)
      out += string[at];
    else
      append_encoded(out, code_point(std::string_view(string).substr(at, length)));
    at += length == 0 ? 1 : length;
  }
  return out;
}

/// The number at the front of a text: where its mantissa ends, and where the trailing zeros of its
/// fraction begin. Pre: a digit is there.
struct Number {
  std::size_t zeros = 0, mantissa = 0;
  explicit Number(std::string_view text) {
    while (mantissa < text.size() && is_digit(text[mantissa])) ++mantissa;
    zeros = mantissa;
    if (mantissa == text.size() || text[mantissa] != '.') return;
    zeros = ++mantissa;
    for (; mantissa < text.size() && is_digit(text[mantissa]); ++mantissa)
      if (text[mantissa] != '0') zeros = mantissa + 1;
  }
};

}  // namespace

std::string tidy_exchange_text(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '\'') {  // a doubled quote in a string is taken for the start of another one
      const std::size_t end = std::min(text.find('\'', at + 1), text.size() - 1) + 1;
      std::string string(text.substr(at, end - at));
      std::erase(string, '\n');
      out += encoded(string);
      at = end;
    } else if (is_digit(c)) {
      const Number number(text.substr(at));
      out += text.substr(at, number.zeros);
      at += number.mantissa;
    } else if (c == '\n' && !out.empty() && out.back() != ';') {
      at = std::min(text.find_first_not_of("\n ", at), text.size());
    } else {
      out += c;
      ++at;
    }
  }
  return out;
}

}  // namespace remeshd::kernel
