#pragma once

#include <string>
#include <string_view>

namespace remeshd {

/// A TOML text with every byte that is not ASCII told by ASCII characters that TOML takes in
/// strings and comments only. toml++ 3.3 runs into undefined behaviour at characters such as U+00E9
/// outside of them, and behind a backslash within, where it should refuse them or take them.
class AsciiForm {
 public:
  /// A mark of the byte order at the beginning is left out.
  explicit AsciiForm(std::string_view text);

  [[nodiscard]] const std::string& text() const { return text_; }
  /// A part of what was read of the text (a key, a value, an error) as it was.
  [[nodiscard]] std::string original(std::string_view part) const;

 private:
  std::string mark_;  ///< what tells of a byte; its two digits follow
  std::string text_;
};

}  // namespace remeshd
