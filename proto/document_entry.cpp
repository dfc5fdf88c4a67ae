// SPDX-License-Identifier: Apache-2.0
#include "proto/document_entry.h"

#include <set>

namespace remeshd {
namespace {

using google::protobuf::Value;

/// `zAxis` of `z_axis`.
std::string camel_case(std::string_view snake) {
  std::string out;
  bool raise = false;
  for (const char c : snake) {
    if (c == '_') {
      raise = true;
      continue;
    }
    out += raise && c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    raise = false;
  }
  return out;
}

}  // namespace

const char* Entry::kind() const {
  static constexpr const char* kNames[] = {"null",     "true or false", "a number",
                                           "a string", "a list",        "an object"};
  return kNames[json_.value.index()];
}

const std::string& Entry::text() const {
  if (const auto* text = std::get_if<std::string>(&json_.value)) return *text;
  throw wrong_kind("a string", kind());
}

double Entry::number() const {
  if (const auto* number = std::get_if<double>(&json_.value)) return *number;
  throw wrong_kind("a number", kind());
}

bool Entry::boolean() const {
  if (const auto* value = std::get_if<bool>(&json_.value)) return *value;
  throw wrong_kind("true or false", kind());
}

const Json::List& Entry::list() const {
  if (const auto* list = std::get_if<Json::List>(&json_.value)) return *list;
  throw wrong_kind("a list", kind());
}

const Json::Object& Entry::object() const {
  if (const auto* object = std::get_if<Json::Object>(&json_.value)) return *object;
  throw wrong_kind("an object", kind());
}

void Entry::scalar(Value& out) const {
  if (!std::holds_alternative<double>(json_.value) && !is_text())
    throw wrong_kind("a number or an expression", kind());
  value(out);
}

void Entry::value(Value& out) const {
  if (const auto* number = std::get_if<double>(&json_.value)) {
    out.set_number_value(*number);
  } else if (const auto* text = std::get_if<std::string>(&json_.value)) {
    out.set_string_value(*text);
  } else if (std::holds_alternative<Json::List>(json_.value)) {
    auto& values = *out.mutable_list_value();
    each([&](const Entry& entry) { entry.value(*values.add_values()); });
  } else if (is_object()) {
    auto& values = *out.mutable_struct_value()->mutable_fields();
    members([&](const std::string& name, const Entry& entry) { entry.value(values[name]); });
  } else {
    throw wrong_kind("a number, an expression or a list", kind());
  }
}

void Entry::fields(const Fields& fields) const {
  std::set<std::string_view> seen;
  for (const auto& [name, position, value] : object()) {
    auto field = fields.find(name);
    if (field == fields.end()) field = fields.find(camel_case(name));
    if (field == fields.end() || !spells(name, field->first)) {
      std::string known;
      for (const auto& [key, reader] : fields)
        known += (known.empty() ? "" : ", ") + std::string(key);
      DocumentPlace place = place_;
      place.at = position;
      throw error::unknown_field(place, name, known);
    }
    if (!seen.insert(field->first).second) throw error::duplicate_key(position, name);
    field->second(below(value, field->first));
  }
}

std::optional<Entry> Entry::find(std::string_view field) const {
  if (!is_object()) return std::nullopt;
  for (const auto& [name, position, value] : object())
    if (spells(name, field)) return below(value, field);
  return std::nullopt;
}

void Entry::require(std::initializer_list<std::string_view> fields) const {
  if (!is_object()) throw wrong_kind("an object", kind());
  for (const std::string_view field : fields)
    if (!find(field)) throw error::missing_field(place_, field);
}

void Entry::exclude(std::string_view one, std::string_view other) const {
  if (find(one) && find(other))
    throw wrong_kind("one of " + std::string(one) + " and " + std::string(other), "both");
}

Entry Entry::of_feature(const std::string& id) const {
  Entry out = *this;
  out.place_.feature = id;
  out.place_.path.clear();
  return out;
}

Entry Entry::of_edit(int index) const {
  Entry out = *this;
  out.place_.edit_index = index;
  return out;
}

Entry Entry::at_path(const std::string& path) const {
  Entry out = *this;
  out.place_.path = path;
  return out;
}

Entry Entry::at(const Json& json, std::size_t index) const {
  DocumentPlace place = place_;
  place.path += '[' + std::to_string(index) + ']';
  return {json, std::move(place)};
}

Entry Entry::below(const Json& json, std::string_view name) const {
  DocumentPlace place = place_;
  if (!place.path.empty()) place.path += '.';
  place.path += name;
  return {json, std::move(place)};
}

}  // namespace remeshd
