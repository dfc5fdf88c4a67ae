#include "server/config/plain_characters.h"

#include <algorithm>

#include "server/config/config_error.h"

namespace remeshd {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Goes through a text once.
class Scan {
 public:
  Scan(std::string_view text, const std::string& name) : text_(text), name_(name) {
    if (text.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
  }

  void run() {
    while (at_ < text_.size()) {
      if (opens() && (starts("\"\"\"") || starts("'''")))
        string(text_.substr(at_, 3));
      else if (opens() && (starts("\"") || starts("'")))
        string(text_.substr(at_, 1));
      else if (starts("#"))
        at_ = std::min(text_.find('\n', at_), text_.size());
      else
        plain();
    }
  }

 private:
  [[nodiscard]] bool starts(std::string_view with) const {
    return text_.substr(at_).starts_with(with);
  }

  /// Whether a quote here begins a string, as where a key or a value may begin.
  [[nodiscard]] bool opens() const {
    return std::string_view("\n=[{,.").find(before_) != std::string_view::npos;
  }

  void plain() {
    if (static_cast<unsigned char>(text_[at_]) >= 0x80)
      throw ConfigError(name_ + ":" +
                        std::to_string(1 + std::count(text_.begin(), text_.begin() + at_, '\n')) +
                        ": a character that is not ASCII stands outside of quotes");
    if (text_[at_] != ' ' && text_[at_] != '\t') before_ = text_[at_];
    ++at_;
  }

  void string(std::string_view quotes) {
    const bool escapes = quotes.front() == '"';
    at_ += quotes.size();
    while (at_ < text_.size() && !starts(quotes)) {
      // One that does not end in its line is an error that toml++ tells.
      if (quotes.size() == 1 && text_[at_] == '\n') break;
      if (escapes && text_[at_] == '\\')
        escape();
      else
        ++at_;
    }
    if (starts(quotes)) at_ += quotes.size();
    before_ = quotes.front();
  }

  /// What stands behind a backslash, be it blanks and line breaks, is read as if it were plain.
  void escape() {
    ++at_;
    const std::size_t behind = text_.find_first_not_of(" \t\r\n", at_);
    const bool blanks = behind != at_;
    at_ = std::min(behind, text_.size());
    if (at_ < text_.size() && (!blanks || static_cast<unsigned char>(text_[at_]) >= 0x80)) plain();
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  char before_ = '\n';  ///< the last that was no blank
};

}  // namespace

void check_plain_characters(std::string_view text, const std::string& name) {
  Scan(text, name).run();
}

}  // namespace remeshd
