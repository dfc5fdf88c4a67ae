// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <concepts>
#include <string>
#include <string_view>
#include <vector>

namespace remeshd::client {

/// Appends an integer in decimal.
template <std::integral T>
void append(std::string& out, T value) {
  char buffer[24];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  out.append(buffer, end);
}

/// Appends the shortest decimal number that reads back to the same bits, in the notation given.
inline void append(std::string& out, double value, std::chars_format format) {
  char buffer[400];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, format).ptr;
  out.append(buffer, end);
}

/// The names with `+` between them: `base+slot1`.
inline std::string joined(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) {
    if (!out.empty()) out += '+';
    out += name;
  }
  return out;
}

}  // namespace remeshd::client
