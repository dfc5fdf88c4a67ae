#include "server/session/references.h"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "server/session/session_error.h"

namespace remeshd {
namespace {

constexpr std::size_t kShortestPrefix = 8;
constexpr std::size_t kIdDigits = 64;

bool all_hexadecimal(const std::string& text) {
  return std::all_of(text.begin(), text.end(),
                     [](unsigned char c) { return std::isxdigit(c) != 0; });
}

bool looks_like_id(const std::string& text) {
  return text.size() >= kShortestPrefix && text.size() <= kIdDigits && all_hexadecimal(text);
}

Reference at_number(Catalogue& catalogue, const std::string& text, std::size_t at) {
  const std::string design = text.substr(0, at);
  std::uint32_t number = 0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data() + at + 1, end, number);
  if (parsed.ec != std::errc{} || parsed.ptr != end)
    throw error::revision_not_found(text, "after the `@` stands a revision's number");
  if (!catalogue.design(design)) throw error::design_not_found(design);
  const auto id = catalogue.at(design, number);
  if (!id) throw error::revision_not_found(text, "the design has no such number (any more)");
  return {*id, design, number};
}

}  // namespace

Reference resolve(Catalogue& catalogue, const std::string& text) {
  if (const std::size_t at = text.rfind('@'); at != std::string::npos)
    return at_number(catalogue, text, at);
  if (const auto design = catalogue.design(text)) {
    if (design->head.empty()) throw error::design_empty(text);
    return {design->head, text, design->head_number};
  }
  if (!all_hexadecimal(text) || text.size() > kIdDigits)
    throw error::revision_not_found(text, "no design has that name, and it is no id");
  if (text.size() < kShortestPrefix)
    throw error::revision_not_found(text, "an id takes at least 8 digits");
  std::string prefix = text;
  std::transform(prefix.begin(), prefix.end(), prefix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto ids = catalogue.with_prefix(prefix, 2);
  if (ids.empty()) throw error::revision_not_found(text, "no revision's id begins like that");
  if (ids.size() > 1) throw error::revision_ambiguous(text);
  return {ids.front(), "", 0};
}

std::optional<std::string> design_named_by(const std::string& text) {
  const std::string name = text.substr(0, text.rfind('@'));
  if (name.empty() || looks_like_id(name)) return std::nullopt;
  return name;
}

void check_design_name(const std::string& name) {
  if (name.empty()) throw error::design_name_invalid("is empty");
  if (name.size() > 128) throw error::design_name_invalid("is longer than 128 bytes");
  for (const char c : name) {
    if (c == '@') throw error::design_name_invalid("contains an `@`");
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
      throw error::design_name_invalid("contains a control character");
  }
  if (looks_like_id(name)) throw error::design_name_invalid("looks like a revision's id");
}

}  // namespace remeshd
