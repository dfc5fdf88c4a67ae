// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <google/protobuf/struct.pb.h>

#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "proto/document_error.h"
#include "proto/json_reader.h"

namespace remeshd {

/// A value of a document with its place, on its way into a message. All functions throw
/// DocumentError `WRONG_KIND` where the value is of another kind than they read.
class Entry {
 public:
  using Reader = std::function<void(const Entry&)>;
  /// What reads each field of an object, by its name in camelCase.
  using Fields = std::map<std::string_view, Reader>;

  Entry(const Json& json, DocumentPlace place) : json_(json), place_(std::move(place)) {
    place_.at = json.at;
  }
  [[nodiscard]] const DocumentPlace& place() const { return place_; }

  [[nodiscard]] const std::string& text() const;
  /// Reads a text into `out`, which must outlive the reader.
  static Reader into(std::string* out) {
    return [out](const Entry& entry) { *out = entry.text(); };
  }
  [[nodiscard]] double number() const;
  [[nodiscard]] bool boolean() const;
  /// One of some names; `wanted` reads like "\"ADDITIVE\" or \"SUBTRACTIVE\"".
  template <typename Value>
  [[nodiscard]] Value choice(const char* wanted,
                             std::initializer_list<std::pair<std::string_view, Value>> names) const;
  /// A number or an expression.
  void scalar(google::protobuf::Value& out) const;
  /// Any value but null and booleans, which no document has a use for.
  void value(google::protobuf::Value& out) const;

  [[nodiscard]] bool is_text() const { return std::holds_alternative<std::string>(json_.value); }
  [[nodiscard]] bool is_object() const { return std::holds_alternative<Json::Object>(json_.value); }

  /// Calls `read` with each entry of a list.
  template <typename Read>
  void each(Read&& read) const {
    const Json::List& entries = list();
    for (std::size_t i = 0; i < entries.size(); ++i) read(at(entries[i], i));
  }
  /// As many scalars, each to what `add` returns.
  template <typename Add>
  void scalars(std::size_t count, Add&& add) const {
    if (list().size() != count)
      throw wrong_kind(std::to_string(count) + " values", std::to_string(list().size()));
    each([&](const Entry& entry) { entry.scalar(*add()); });
  }
  /// Calls `read` with name and value of each member of an object, in the order written.
  template <typename Read>
  void members(Read&& read) const {
    for (const Json::Member& member : object()) read(member.name, below(member.value, member.name));
  }

  /// Reads an object; a name may be in snake_case too.
  /// Throws DocumentError: `UNKNOWN_FIELD` for what stands in no table, `DUPLICATE_KEY` where a
  /// field stands there in both spellings.
  void fields(const Fields& fields) const;
  /// The member of an object, if it is one and has it.
  [[nodiscard]] std::optional<Entry> find(std::string_view field) const;
  /// Throws DocumentError: `MISSING_FIELD`.
  void require(std::initializer_list<std::string_view> fields) const;
  /// Refuses an object that has both.
  void exclude(std::string_view one, std::string_view other) const;

  /// The same value under another place: that of a feature, which is known by its id.
  [[nodiscard]] Entry of_feature(const std::string& id) const;
  [[nodiscard]] Entry of_edit(int index) const;
  [[nodiscard]] Entry at_path(const std::string& path) const;

  [[nodiscard]] DocumentError wrong_kind(std::string_view wanted, std::string_view found) const {
    return error::wrong_kind(place_, wanted, found);
  }
  [[nodiscard]] const char* kind() const;

 private:
  [[nodiscard]] const Json::List& list() const;
  [[nodiscard]] const Json::Object& object() const;
  [[nodiscard]] Entry at(const Json& json, std::size_t index) const;
  [[nodiscard]] Entry below(const Json& json, std::string_view name) const;

  const Json& json_;
  DocumentPlace place_;
};

template <typename Value>
Value Entry::choice(const char* wanted,
                    std::initializer_list<std::pair<std::string_view, Value>> names) const {
  if (!is_text()) throw wrong_kind(wanted, kind());
  for (const auto& [name, value] : names)
    if (text() == name) return value;
  throw wrong_kind(wanted, "another string");
}

}  // namespace remeshd
