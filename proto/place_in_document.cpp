// SPDX-License-Identifier: Apache-2.0
#include "proto/place_in_document.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <ranges>
#include <string>

#include "proto/json_reader.h"

namespace remeshd {
namespace {

const Json* member(const Json* json, std::string_view field) {
  const auto* object = json != nullptr ? std::get_if<Json::Object>(&json->value) : nullptr;
  if (object == nullptr) return nullptr;
  const auto found =
      std::ranges::find_if(*object, [&](const auto& m) { return spells(m.name, field); });
  return found != object->end() ? &found->value : nullptr;
}

const Json* item(const Json* json, std::size_t index) {
  const auto* list = json != nullptr ? std::get_if<Json::List>(&json->value) : nullptr;
  return list != nullptr && index < list->size() ? &(*list)[index] : nullptr;
}

std::string_view text_of(const Json* json) {
  const auto* text = json != nullptr ? std::get_if<std::string>(&json->value) : nullptr;
  return text != nullptr ? std::string_view(*text) : std::string_view();
}

/// `placement` of `placement.origin[1]`, which is left with `.origin[1]`.
std::string_view take_name(std::string_view& path) {
  if (path.starts_with('.')) path.remove_prefix(1);
  const std::string_view name = path.substr(0, path.find_first_of(".["));
  path.remove_prefix(name.size());
  return name;
}

/// The value that a path leads to from `json`, or as far as it leads.
const Json* follow(const Json* json, std::string_view path) {
  while (!path.empty()) {
    const Json* next = nullptr;
    if (path.starts_with('[')) {
      std::size_t index = std::numeric_limits<std::size_t>::max();
      std::from_chars(path.data() + 1, path.data() + path.size(), index);
      next = item(json, index);
      const std::size_t end = path.find(']');
      path.remove_prefix(end == std::string_view::npos ? path.size() : end + 1);
    } else {
      next = member(json, take_name(path));
    }
    if (next == nullptr) return json;
    json = next;
  }
  return json;
}

/// A parameter of a feature, else the feature.
const Json* in_feature(const Json* feature, std::string_view parameter) {
  std::string_view rest = parameter;
  const std::string_view first = take_name(rest);
  const bool of_its_own = first == "placement" || first == "reference" ||
                          first == "referencePoint" || first == "id" || first == "type";
  const Json* value = member(of_its_own ? feature : member(feature, "parameters"), first);
  return value != nullptr ? follow(value, rest) : feature;
}

/// `holes` of `sizes.holes.in.ball[3]`, which is left with `.in.ball[3]`; empty where the path does
/// not begin with `list`.
std::string_view take_entry(std::string_view& path, std::string_view list) {
  std::string_view rest = path;
  if (take_name(rest) != list || !rest.starts_with('.')) return {};
  const std::string_view name = take_name(rest);
  path = rest;
  return name;
}

const Json* in_sizes(const Json* sizes, std::string_view id, std::string_view path) {
  const auto* list = sizes != nullptr ? std::get_if<Json::List>(&sizes->value) : nullptr;
  if (list == nullptr) return nullptr;
  for (const Json& size : std::views::reverse(*list))
    if (text_of(member(&size, "id")) == id) return follow(&size, path);
  return nullptr;
}

/// A group is a member of an object: its selector, or an object with that.
const Json* in_group(const Json* groups, std::string_view name, std::string_view path) {
  const Json* group = member(groups, name);
  return group != nullptr ? follow(group, path) : groups;
}

const Json* in_model(const Json* model, const ValueAtFault& what) {
  std::string_view of_size = what.parameter;
  if (const std::string_view size = take_entry(of_size, "sizes"); !size.empty())
    return in_sizes(member(model, "sizes"), size, of_size);
  std::string_view of_group = what.parameter;
  if (const std::string_view group = take_entry(of_group, "groups"); !group.empty())
    return in_group(member(model, "groups"), group, of_group);
  if (what.feature.empty()) return member(member(model, "parameters"), what.parameter);
  const Json* features = member(model, "features");
  const auto* list = features != nullptr ? std::get_if<Json::List>(&features->value) : nullptr;
  if (list == nullptr) return nullptr;
  // Of two with the same id the later one is at fault.
  for (const Json& feature : std::views::reverse(*list))
    if (text_of(member(&feature, "id")) == what.feature)
      return in_feature(&feature, what.parameter);
  return nullptr;
}

/// Where an edit sets it, null where it does not.
const Json* in_edit(const Json* edit, const ValueAtFault& what) {
  std::string_view rest = what.parameter;
  const std::string_view first = take_name(rest);
  const auto is = [](const Json* json, std::string_view text) {
    return !text.empty() && text_of(json) == text;
  };
  if (const Json* set = member(edit, "setParameter"))
    return what.feature.empty() && is(member(set, "name"), what.parameter) ? member(set, "value")
                                                                           : nullptr;
  if (const Json* set = member(edit, "setFeatureParameter"))
    return is(member(set, "feature"), what.feature) && is(member(set, "name"), first)
               ? follow(member(set, "value"), rest)
               : nullptr;
  if (const Json* set = member(edit, "setPlacement"))
    return is(member(set, "feature"), what.feature) && first == "placement"
               ? follow(member(set, "placement"), rest)
               : nullptr;
  if (const Json* set = member(edit, "setSize")) {
    std::string_view of_size = what.parameter;
    return is(member(set, "id"), take_entry(of_size, "sizes")) ? follow(set, of_size) : nullptr;
  }
  if (const Json* set = member(edit, "setGroup")) {
    std::string_view of_group = what.parameter;
    return is(member(set, "name"), take_entry(of_group, "groups")) ? follow(set, of_group)
                                                                   : nullptr;
  }
  if (const Json* added = member(member(edit, "addFeature"), "feature"))
    return is(member(added, "id"), what.feature) ? in_feature(added, what.parameter) : nullptr;
  return nullptr;
}

const Json* in_edits(const Json* edits, const ValueAtFault& what) {
  if (what.edit_index) {
    const Json* edit = item(edits, *what.edit_index);
    const Json* value = in_edit(edit, what);
    return value != nullptr ? value : edit;
  }
  const auto* list = std::get_if<Json::List>(&edits->value);
  if (list == nullptr) return nullptr;
  for (const Json& edit : std::views::reverse(*list))
    if (const Json* value = in_edit(&edit, what)) return value;
  return nullptr;
}

}  // namespace

TextPosition place_in_document(std::string_view text, const ValueAtFault& what) {
  if (what.feature.empty() && what.parameter.empty() && !what.edit_index) return {};
  try {
    const Json document = read_json(text);
    const Json* edits = member(&document, "edits");
    const Json* value = edits != nullptr ? in_edits(edits, what) : in_model(&document, what);
    return value != nullptr ? value->at : TextPosition{};
  } catch (const DocumentError&) {
    return {};
  }
}

}  // namespace remeshd
