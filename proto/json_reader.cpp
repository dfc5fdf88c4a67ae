// SPDX-License-Identifier: Apache-2.0
#include "proto/json_reader.h"

#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>
#include <unordered_set>

namespace remeshd {
namespace {

/// The text as nlohmann's parser takes it, which tells how far the parser has come.
class Counted {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  Counted(const char* at, const char** reached) : at_(at), reached_(reached) {}
  reference operator*() const { return *at_; }
  Counted& operator++() {
    *reached_ = ++at_;
    return *this;
  }
  Counted operator++(int) {
    const Counted before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const Counted& a, const Counted& b) { return a.at_ == b.at_; }

 private:
  const char* at_;
  const char** reached_;
};

/// Line and column while a text is gone through once. Columns count characters, not bytes.
class Position {
 public:
  explicit Position(const char* at) : at_(at) {}
  TextPosition advance(const char* to) {
    for (; at_ < to; ++at_) {
      if (*at_ == '\n') {
        ++now_.line;
        now_.column = 1;
      } else if ((static_cast<unsigned char>(*at_) & 0xC0U) != 0x80U) {
        ++now_.column;
      }
    }
    return now_;
  }

 private:
  const char* at_;
  TextPosition now_{1, 1};
};

/// Builds the tree from the events of nlohmann's parser, and stops it by throwing.
class TreeBuilder {
 public:
  TreeBuilder(std::string_view text, const char* const& reached, const DocumentLimits& limits)
      : text_(text), reached_(reached), limits_(limits), end_(text.data()), position_(end_) {}

  Json take() { return std::move(root_); }

  bool null() { return put({Json::Null{}}); }
  bool boolean(bool value) { return put({value}); }
  bool number_integer(std::int64_t value) { return put({static_cast<double>(value)}); }
  bool number_unsigned(std::uint64_t value) { return put({static_cast<double>(value)}); }
  /// Zero loses its sign, as `-0`, which is a whole number, does.
  bool number_float(double value, const std::string& /*text*/) { return put({value + 0.0}); }
  bool string(std::string& value) { return put({std::move(value)}); }
  bool binary(nlohmann::json::binary_t& /*value*/) { return false; }

  bool start_object(std::size_t /*size*/) { return open({Json::Object{}}); }
  bool end_object() { return close(); }
  bool start_array(std::size_t /*size*/) { return open({Json::List{}}); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    key_at_ = begin_token();
    if (!open_.back().keys.insert(name).second) throw error::duplicate_key(key_at_, name);
    key_ = std::move(name);
    return true;
  }

  bool parse_error(std::size_t position, const std::string& /*token*/,
                   const nlohmann::json::exception& why) {
    // The position is one past the character that does not fit.
    const std::size_t at = std::min(std::max<std::size_t>(position, 1) - 1, text_.size());
    throw error::document_malformed(Position(text_.data()).advance(text_.data() + at),
                                    cause(why.what()));
  }

 private:
  struct Open {
    Json* container;
    std::unordered_set<std::string> keys;
  };

  /// nlohmann writes "[json.exception...] parse error at line 1, column 2: syntax error while
  /// parsing value - invalid literal; last read: '...'": the part after the last colon that
  /// belongs to it tells the cause.
  static std::string cause(std::string_view what) {
    for (const std::string_view mark : {"syntax error ", "number overflow "}) {
      const std::size_t at = what.find(mark);
      if (at == std::string_view::npos) continue;
      std::string text(what.substr(at, 200));
      return text;
    }
    return std::string(what.substr(0, 200));
  }

  /// Where the token begins that the parser has just read. Between two tokens stand white space,
  /// commas and colons alone, or the parser would have stopped.
  TextPosition begin_token() {
    const char* const limit = text_.data() + text_.size();
    while (end_ < limit && std::string_view(" \t\r\n,:").find(*end_) != std::string_view::npos)
      ++end_;
    const TextPosition at = position_.advance(end_);
    end_ = reached_;
    return at;
  }

  Json* place(Json&& value) {
    value.at = begin_token();
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    auto& container = open_.back().container->value;
    if (auto* list = std::get_if<Json::List>(&container)) {
      list->push_back(std::move(value));
      return &list->back();
    }
    auto& object = std::get<Json::Object>(container);
    object.push_back({std::move(key_), key_at_, std::move(value)});
    return &object.back().value;
  }
  bool put(Json&& value) {
    place(std::move(value));
    return true;
  }
  /// The container opened stays where it is until it is closed: only its last child grows.
  bool open(Json&& value) {
    const bool too_deep = static_cast<int>(open_.size()) >= limits_.depth;
    Json* container = place(std::move(value));
    if (too_deep) throw error::document_too_deep(container->at, limits_.depth);
    open_.push_back({container, {}});
    return true;
  }
  bool close() {
    end_ = reached_;
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  const char* const& reached_;  ///< one past what the parser has read
  DocumentLimits limits_;
  const char* end_;  ///< of the token before; a number's may lie one further
  Position position_;
  Json root_;
  std::string key_;
  TextPosition key_at_;
  std::vector<Open> open_;
};

}  // namespace

Json read_json(std::string_view text, const DocumentLimits& limits) {
  if (text.size() > limits.bytes) throw error::document_too_large(text.size(), limits.bytes);
  const char* reached = text.data();
  TreeBuilder builder(text, reached, limits);
  nlohmann::json::sax_parse(Counted(text.data(), &reached),
                            Counted(text.data() + text.size(), &reached), &builder);
  return builder.take();
}

bool spells(std::string_view written, std::string_view field) {
  std::string snake;
  for (const char c : field) {
    const bool capital = c >= 'A' && c <= 'Z';
    if (capital) snake += '_';
    snake += capital ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return written == field || written == snake;
}

}  // namespace remeshd
