// SPDX-License-Identifier: Apache-2.0
#include "proto/json_reader.h"

#include <nlohmann/json.hpp>
#include <unordered_set>

#include "proto/document_error.h"

namespace remeshd {
namespace {

/// Builds the tree from the events of nlohmann's parser, and stops it by throwing.
class TreeBuilder {
 public:
  TreeBuilder(std::string_view text, const DocumentLimits& limits) : text_(text), limits_(limits) {}

  Json take() { return std::move(root_); }

  bool null() { return put({Json::Null{}}); }
  bool boolean(bool value) { return put({value}); }
  bool number_integer(std::int64_t value) { return put({static_cast<double>(value)}); }
  bool number_unsigned(std::uint64_t value) { return put({static_cast<double>(value)}); }
  bool number_float(double value, const std::string& /*text*/) { return put({value}); }
  bool string(std::string& value) { return put({std::move(value)}); }
  bool binary(nlohmann::json::binary_t& /*value*/) { return false; }

  bool start_object(std::size_t /*size*/) { return open({Json::Object{}}); }
  bool end_object() { return close(); }
  bool start_array(std::size_t /*size*/) { return open({Json::List{}}); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    if (!open_.back().keys.insert(name).second) throw error::duplicate_key(name);
    key_ = std::move(name);
    return true;
  }

  bool parse_error(std::size_t position, const std::string& /*token*/,
                   const nlohmann::json::exception& why) {
    const std::size_t end = std::min(position, text_.size());
    std::size_t line = 1;
    std::size_t column = 0;
    for (std::size_t i = 0; i < end; ++i) {
      ++column;
      if (text_[i] == '\n') {
        ++line;
        column = 0;
      }
    }
    throw error::document_malformed(line, column, cause(why.what()));
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

  Json* place(Json&& value) {
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
    object.push_back({std::move(key_), std::move(value)});
    return &object.back().value;
  }
  bool put(Json&& value) {
    place(std::move(value));
    return true;
  }
  /// The container opened stays where it is until it is closed: only its last child grows.
  bool open(Json&& value) {
    if (static_cast<int>(open_.size()) >= limits_.depth)
      throw error::document_too_deep(limits_.depth);
    Json* container = place(std::move(value));
    open_.push_back({container, {}});
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  DocumentLimits limits_;
  Json root_;
  std::string key_;
  std::vector<Open> open_;
};

}  // namespace

Json read_json(std::string_view text, const DocumentLimits& limits) {
  if (text.size() > limits.bytes) throw error::document_too_large(text.size(), limits.bytes);
  TreeBuilder builder(text, limits);
  nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
}

}  // namespace remeshd
