// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <charconv>
#include <cstring>
#include <string>
#include <string_view>

#include "remeshd/mesh_file.h"

namespace remeshd::client {

/// Reads a buffer from front to back: words, numbers and lines of text, and raw values. Every
/// function throws FileError where the buffer ends too soon or holds something else.
class Scanner {
 public:
  explicit Scanner(std::string_view bytes) : bytes_(bytes) {}

  [[nodiscard]] bool at_end() const { return at_ >= bytes_.size(); }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }

  /// The rest of the line, without its end.
  std::string_view line() {
    if (at_end()) throw FileError("it ends too soon");
    const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    std::string_view text = bytes_.substr(at_, end - at_);
    at_ = std::min(end + 1, bytes_.size());
    if (text.ends_with('\r')) text.remove_suffix(1);
    return text;
  }

  /// Passes over blanks; false where nothing follows.
  bool skip_blanks() {
    while (!at_end() && is_blank(bytes_[at_])) ++at_;
    return !at_end();
  }

  std::string_view word() {
    if (!skip_blanks()) throw FileError("it ends too soon");
    const std::size_t start = at_;
    while (!at_end() && !is_blank(bytes_[at_])) ++at_;
    return bytes_.substr(start, at_ - start);
  }

  template <class T>
  T number() {
    return to_number<T>(word());
  }

  template <class T>
  T raw() {
    if (left() < sizeof(T)) throw FileError("it ends too soon");
    T value;
    std::memcpy(&value, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }

  void skip(std::size_t count) {
    if (left() < count) throw FileError("it ends too soon");
    at_ += count;
  }

  /// Goes on behind the next line that is `text`; false, and stays, where there is none.
  bool skip_past_line(std::string_view text) {
    for (std::size_t found = bytes_.find(text, at_); found != std::string_view::npos;
         found = bytes_.find(text, found + 1)) {
      const std::size_t end = found + text.size();
      const bool starts = found == 0 || bytes_[found - 1] == '\n';
      if (starts && (end == bytes_.size() || bytes_[end] == '\n' || bytes_[end] == '\r')) {
        at_ = std::min(bytes_.find('\n', end), bytes_.size() - 1) + 1;
        return true;
      }
    }
    return false;
  }

  template <class T>
  static T to_number(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    if (text.starts_with('+')) text.remove_prefix(1);
    T value{};
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc{} || end != text.data() + text.size())
      throw FileError("'" + std::string(text.substr(0, 40)) + "' stands where a number is due");
    return value;
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace remeshd::client
