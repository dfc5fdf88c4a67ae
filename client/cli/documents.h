#pragma once

#include <istream>
#include <map>
#include <string>

namespace remeshd::cli {

/// The documents that a command line names, each read once: the standard input can be read no
/// second time, and the place of an error is looked for in the text that was sent.
class Documents {
 public:
  /// `in`: the standard input.
  explicit Documents(std::istream& in) : in_(in) {}

  /// The text of a file, or of the standard input where the name is `-`. Throws DocumentError.
  const std::string& text(const std::string& name);
  /// The text of a document that has been read already; null where it has not.
  [[nodiscard]] const std::string* find(const std::string& name) const;
  /// As messages call a document: its file, or `<stdin>`.
  static std::string shown(const std::string& name);

 private:
  std::istream& in_;
  std::map<std::string, std::string> texts_;
};

/// The name that stands for the standard streams on the command line.
inline constexpr const char* kStandardStream = "-";

}  // namespace remeshd::cli
