#include "engine/model/selection/selector.h"

#include <algorithm>

#include "engine/model/selection/size_error.h"

namespace remeshd {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto is_space = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

bool may_stand_in_a_term(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '.' || c == '*' || c == '?';
}

/// Whether a glob stands for all of a name. Of stars only the last is ever gone back to: what those
/// before it stand for never has to be longer.
bool matches(std::string_view glob, std::string_view name) {
  constexpr std::size_t kNone = std::string_view::npos;
  std::size_t g = 0, n = 0, after_star = kNone, taken = 0;
  while (n < name.size()) {
    if (g < glob.size() && glob[g] == '*') {
      after_star = ++g;
      taken = n;
    } else if (g < glob.size() && (glob[g] == '?' || glob[g] == name[n])) {
      ++g;
      ++n;
    } else if (after_star != kNone) {
      g = after_star;
      n = ++taken;
    } else {
      return false;
    }
  }
  return glob.find_first_not_of('*', g) == kNone;
}

}  // namespace

Selector::Selector(std::string_view text, std::string_view parameter) {
  if (text.find('&') != std::string_view::npos) throw error::condition_unsupported(parameter);
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('|', begin), text.size());
    const std::string_view term = trimmed(text.substr(begin, end - begin));
    if (term.empty()) throw error::selector_invalid(parameter, text, "has an empty term");
    if (term.size() > kSelectorLimits.term_length)
      throw error::selector_invalid(parameter, text, "has a term longer than any name");
    if (!std::ranges::all_of(term, may_stand_in_a_term))
      throw error::selector_invalid(parameter, text, "has a character that no name has");
    if (terms_.size() == kSelectorLimits.terms)
      throw error::selector_invalid(
          parameter, text, "has more than " + std::to_string(kSelectorLimits.terms) + " terms");
    terms_.emplace_back(term);
    begin = end + 1;
  }
}

bool Selector::names(std::string_view feature) const {
  return std::ranges::any_of(terms_,
                             [&](const std::string& term) { return matches(term, feature); });
}

bool Selector::names(std::string_view feature, std::string_view face) const {
  const std::string name = std::string(feature) + "." + std::string(face);
  return names(feature) || names(name);
}

}  // namespace remeshd
