#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace remeshd {

struct SelectorLimits {
  std::size_t term_length = 160;  ///< characters: no name is longer
  std::size_t terms = 64;         ///< of one selector
  /// Of one model: what its selectors may ask, feature by feature and term by term.
  std::size_t questions = 1'000'000;
};
inline constexpr SelectorLimits kSelectorLimits;

/// Names faces of features: globs with `|` between them, each over names of faces (`hole*.wall`) or
/// over ids of features, all of whose faces it names (`rib`). `*` stands for any characters, `?`
/// for any one.
class Selector {
 public:
  /// Throws Error(SELECTOR_INVALID), or UNSUPPORTED for a condition (`plate.top & z > 10`).
  /// `parameter` says whose selector it is.
  Selector(std::string_view text, std::string_view parameter);

  [[nodiscard]] std::size_t terms() const { return terms_.size(); }
  /// Whether it names all faces of the feature of that id.
  [[nodiscard]] bool names(std::string_view feature) const;
  /// Whether it names this one of its faces.
  [[nodiscard]] bool names(std::string_view feature, std::string_view face) const;

 private:
  std::vector<std::string> terms_;
};

}  // namespace remeshd
