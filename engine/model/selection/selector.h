#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace remeshd {

struct SelectorLimits {
  std::size_t term_length = 160;  ///< characters of a glob: no name is longer
  std::size_t terms = 64;         ///< of one selector
  /// Of one model: tests of a term against a feature.
  std::size_t questions = 1'000'000;
  /// Of one model: its conditions, each counted for every feature that its term names.
  std::size_t conditions = 10'000;
};
inline constexpr SelectorLimits kSelectorLimits;

/// One term of a selector: a glob over names of faces (`hole*.wall`) or over ids of features, all
/// of whose faces it names (`rib`), and maybe a condition on points of those faces. `*` stands for
/// any characters, `?` for any one.
struct SelectorTerm {
  std::string glob;
  std::string condition;  ///< an expression, not read yet; empty: it holds everywhere

  /// Whether it names all faces of the feature of that id.
  [[nodiscard]] bool names(std::string_view feature) const;
  /// Whether it names this face of that feature, alone or with all others.
  [[nodiscard]] bool names(std::string_view feature, std::string_view face) const;
};

/// The terms of a selector: globs, each maybe with a condition behind `&`, with `|` between them
/// (`plate.top & z > 10 | rib`). Within a condition `&&` and `||` are the expression's own.
///
/// Throws Error(SELECTOR_INVALID). `parameter` says whose selector it is.
std::vector<SelectorTerm> read_selector(std::string_view text, std::string_view parameter);

}  // namespace remeshd
