#include "server/service/trace_parent.h"

#include <algorithm>

namespace remeshd {
namespace {

bool is_hex(std::string_view text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

bool is_zero(std::string_view text) { return text.find_first_not_of('0') == text.npos; }

}  // namespace

bool is_trace_parent(std::string_view text) {
  constexpr std::size_t kLength = 55;    // of version 00
  constexpr std::size_t kLongest = 256;  // of a later one, which goes into the log as it is
  if (text.size() < kLength || text.size() > kLongest) return false;
  if (text[2] != '-' || text[35] != '-' || text[52] != '-') return false;
  const std::string_view version = text.substr(0, 2), trace = text.substr(3, 32),
                         parent = text.substr(36, 16), flags = text.substr(53, 2);
  for (const std::string_view part : {version, trace, parent, flags})
    if (!is_hex(part)) return false;
  if (version == "ff" || is_zero(trace) || is_zero(parent)) return false;
  if (text.size() == kLength) return true;
  return version != "00" && text[kLength] == '-' &&
         std::all_of(text.begin(), text.end(), [](char c) { return c > 0x20 && c < 0x7F; });
}

}  // namespace remeshd
