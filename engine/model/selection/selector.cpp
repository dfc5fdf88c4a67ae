#include "engine/model/selection/selector.h"

#include <algorithm>

#include "engine/model/selection/selection_error.h"

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

/// Whether a glob matches all of a name. Backtracking to the last star suffices: the stars before
/// it never have to match more than they did.
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

/// Where the term that begins at `begin` ends: at the next `|` that is not half of a condition's
/// `||`.
std::size_t end_of_term(std::string_view text, std::size_t begin) {
  bool in_condition = false;
  for (std::size_t k = begin; k < text.size(); ++k) {
    if (text[k] == '&') in_condition = true;
    if (text[k] != '|') continue;
    if (!in_condition || k + 1 == text.size() || text[k + 1] != '|') return k;
    ++k;
  }
  return text.size();
}

SelectorTerm read_term(std::string_view text, std::string_view whole, std::string_view parameter) {
  const std::size_t at = text.find('&');
  const std::string_view glob = trimmed(text.substr(0, at));
  if (glob.empty()) throw error::selector_invalid(parameter, whole, "has an empty term");
  if (glob.size() > kSelectorLimits.term_length)
    throw error::selector_invalid(parameter, whole, "has a term longer than any name");
  if (!std::ranges::all_of(glob, may_stand_in_a_term))
    throw error::selector_invalid(parameter, whole, "has a character that no name has");
  if (at == std::string_view::npos) return {std::string(glob), {}};
  const std::string_view condition = trimmed(text.substr(at + 1));
  if (condition.empty()) throw error::selector_invalid(parameter, whole, "has an empty condition");
  if (condition.front() == '&')
    throw error::selector_invalid(parameter, whole, "has && where a condition begins");
  return {std::string(glob), std::string(condition)};
}

}  // namespace

bool SelectorTerm::names(std::string_view feature) const { return matches(glob, feature); }

bool SelectorTerm::names(std::string_view feature, std::string_view face) const {
  return names(feature) || matches(glob, std::string(feature) + "." + std::string(face));
}

std::vector<SelectorTerm> read_selector(std::string_view text, std::string_view parameter) {
  std::vector<SelectorTerm> terms;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = end_of_term(text, begin);
    if (terms.size() == kSelectorLimits.terms)
      throw error::selector_invalid(
          parameter, text, "has more than " + std::to_string(kSelectorLimits.terms) + " terms");
    terms.push_back(read_term(text.substr(begin, end - begin), text, parameter));
    begin = end + 1;
  }
  return terms;
}

}  // namespace remeshd
