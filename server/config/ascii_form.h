#pragma once

#include <string>
#include <string_view>

namespace remeshd {

/// A TOML text in which each byte that is not ASCII is replaced by ASCII characters that TOML
/// accepts in strings and comments only. toml++ 3.3 has undefined behaviour at characters such as
/// U+00E9 outside of these, and after a backslash in strings, where it should refuse or accept
/// them.
class AsciiForm {
 public:
  /// A byte order mark at the beginning is left out.
  explicit AsciiForm(std::string_view text);

  [[nodiscard]] const std::string& text() const { return text_; }
  /// A part of the parsed text (a key, a value, an error) with its original bytes.
  [[nodiscard]] std::string original(std::string_view part) const;

 private:
  std::string mark_;  ///< stands for a byte; its two hexadecimal digits follow
  std::string text_;
};

}  // namespace remeshd
