// SPDX-License-Identifier: Apache-2.0
#include "proto/document.h"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>

#include "proto/document_error.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;
using google::protobuf::ListValue;
using google::protobuf::Value;

const char* kind_of(const Json& json) {
  static constexpr const char* kNames[] = {"null",     "true or false", "a number",
                                           "a string", "a list",        "an object"};
  return kNames[json.value.index()];
}

DocumentPlace below(DocumentPlace place, std::string_view field) {
  if (!place.path.empty()) place.path += '.';
  place.path += field;
  return place;
}

DocumentPlace entry(DocumentPlace place, std::size_t index) {
  place.path += '[' + std::to_string(index) + ']';
  return place;
}

const std::string& string_of(const Json& json, const DocumentPlace& place) {
  if (const auto* text = std::get_if<std::string>(&json.value)) return *text;
  throw error::wrong_kind(place, "a string", kind_of(json));
}

const Json::List& list_of(const Json& json, const DocumentPlace& place) {
  if (const auto* list = std::get_if<Json::List>(&json.value)) return *list;
  throw error::wrong_kind(place, "a list", kind_of(json));
}

const Json::Object& object_of(const Json& json, const DocumentPlace& place) {
  if (const auto* object = std::get_if<Json::Object>(&json.value)) return *object;
  throw error::wrong_kind(place, "an object", kind_of(json));
}

/// What reads each field of an object; fields that stand in no table are errors.
using Fields = std::map<std::string_view, std::function<void(const Json&, const DocumentPlace&)>>;

void read_fields(const Json& json, const DocumentPlace& place, const Fields& fields) {
  for (const auto& [name, value] : object_of(json, place)) {
    const auto field = fields.find(name);
    if (field == fields.end()) {
      std::string known;
      for (const auto& [key, reader] : fields)
        known += (known.empty() ? "" : ", ") + std::string(key);
      throw error::unknown_field(place, name, known);
    }
    field->second(value, below(place, name));
  }
}

const Json* member(const Json& json, std::string_view name) {
  const auto* object = std::get_if<Json::Object>(&json.value);
  if (object == nullptr) return nullptr;
  for (const auto& [key, value] : *object)
    if (key == name) return &value;
  return nullptr;
}

void require(const Json& json, const DocumentPlace& place, std::string_view field) {
  object_of(json, place);
  if (member(json, field) == nullptr) throw error::missing_field(place, field);
}

/// Any value but null and booleans, which no document has a use for.
void read_value(const Json& json, const DocumentPlace& place, Value& out) {
  if (const auto* number = std::get_if<double>(&json.value)) {
    out.set_number_value(*number);
  } else if (const auto* text = std::get_if<std::string>(&json.value)) {
    out.set_string_value(*text);
  } else if (const auto* list = std::get_if<Json::List>(&json.value)) {
    ListValue& values = *out.mutable_list_value();
    for (std::size_t i = 0; i < list->size(); ++i)
      read_value((*list)[i], entry(place, i), *values.add_values());
  } else if (const auto* object = std::get_if<Json::Object>(&json.value)) {
    auto& values = *out.mutable_struct_value()->mutable_fields();
    for (const auto& [name, value] : *object) read_value(value, below(place, name), values[name]);
  } else {
    throw error::wrong_kind(place, "a number, an expression or a list", kind_of(json));
  }
}

void read_scalar(const Json& json, const DocumentPlace& place, Value& out) {
  if (!std::holds_alternative<double>(json.value) &&
      !std::holds_alternative<std::string>(json.value))
    throw error::wrong_kind(place, "a number or an expression", kind_of(json));
  read_value(json, place, out);
}

template <typename Values>
void read_triple(const Json& json, const DocumentPlace& place, Values&& add) {
  const Json::List& list = list_of(json, place);
  if (list.size() != 3) throw error::wrong_kind(place, "3 values", std::to_string(list.size()));
  for (std::size_t i = 0; i < 3; ++i) read_scalar(list[i], entry(place, i), *add());
}

template <typename Map>
void read_values(const Json& json, const DocumentPlace& place, bool scalars, Map& out) {
  for (const auto& [name, value] : object_of(json, place)) {
    DocumentPlace here = place;
    here.path = place.feature.empty() ? below(place, name).path : name;
    (scalars ? read_scalar : read_value)(value, here, out[name]);
  }
}

void read_placement(const Json& json, const DocumentPlace& place, v1::Placement& out) {
  read_fields(json, place,
              {{"origin",
                [&](const Json& j, const DocumentPlace& p) {
                  read_triple(j, p, [&] { return out.add_origin(); });
                }},
               {"zAxis",
                [&](const Json& j, const DocumentPlace& p) {
                  read_triple(j, p, [&] { return out.add_z_axis(); });
                }},
               {"xAxis", [&](const Json& j, const DocumentPlace& p) {
                  read_triple(j, p, [&] { return out.add_x_axis(); });
                }}});
}

void read_nature(const Json& json, const DocumentPlace& place, v1::Feature& out) {
  constexpr const char* kWanted = "\"ADDITIVE\" or \"SUBTRACTIVE\"";
  const auto* name = std::get_if<std::string>(&json.value);
  if (name == nullptr) throw error::wrong_kind(place, kWanted, kind_of(json));
  if (*name == "ADDITIVE") {
    out.set_nature(v1::Feature::ADDITIVE);
  } else if (*name == "SUBTRACTIVE") {
    out.set_nature(v1::Feature::SUBTRACTIVE);
  } else {
    throw error::wrong_kind(place, kWanted, "another string");
  }
}

void read_reference(const Json& json, const DocumentPlace& place, v1::Feature& out) {
  constexpr const char* kWanted = "\"ORIGIN\" or \"CENTRE\"";
  const auto* name = std::get_if<std::string>(&json.value);
  if (name == nullptr) throw error::wrong_kind(place, kWanted, kind_of(json));
  if (*name == "ORIGIN") {
    out.set_reference(v1::Feature::ORIGIN);
  } else if (*name == "CENTRE") {
    out.set_reference(v1::Feature::CENTRE);
  } else {
    throw error::wrong_kind(place, kWanted, "another string");
  }
}

void read_feature(const Json& json, DocumentPlace place, v1::Feature& out) {
  if (const Json* id = member(json, "id")) {
    if (const auto* text = std::get_if<std::string>(&id->value)) {
      place.feature = *text;
      place.path.clear();
    }
  }
  for (const char* field : {"id", "nature", "type"}) require(json, place, field);
  if (member(json, "reference") != nullptr && member(json, "referencePoint") != nullptr)
    throw error::wrong_kind(place, "one of reference and referencePoint", "both");
  read_fields(
      json, place,
      {{"id", [&](const Json& j, const DocumentPlace& p) { out.set_id(string_of(j, p)); }},
       {"nature", [&](const Json& j, const DocumentPlace& p) { read_nature(j, p, out); }},
       {"type", [&](const Json& j, const DocumentPlace& p) { out.set_type(string_of(j, p)); }},
       {"parameters",
        [&](const Json& j, const DocumentPlace& p) {
          read_values(j, p, false, *out.mutable_parameters());
        }},
       {"placement",
        [&](const Json& j, const DocumentPlace& p) {
          read_placement(j, p, *out.mutable_placement());
        }},
       {"reference", [&](const Json& j, const DocumentPlace& p) { read_reference(j, p, out); }},
       {"referencePoint", [&](const Json& j, const DocumentPlace& p) {
          ListValue& point = *out.mutable_reference_point();
          read_triple(j, p, [&] { return point.add_values(); });
        }}});
}

void read_model(const Json& json, v1::FeatureModel& out) {
  require(json, {}, "features");
  read_fields(
      json, {},
      {{"name", [&](const Json& j, const DocumentPlace& p) { out.set_name(string_of(j, p)); }},
       {"unit", [&](const Json& j, const DocumentPlace& p) { out.set_unit(string_of(j, p)); }},
       {"parameters",
        [&](const Json& j, const DocumentPlace& p) {
          read_values(j, p, true, *out.mutable_parameters());
        }},
       {"features", [&](const Json& j, const DocumentPlace& p) {
          const Json::List& list = list_of(j, p);
          for (std::size_t i = 0; i < list.size(); ++i)
            read_feature(list[i], entry(p, i), *out.add_features());
        }}});
}

void read_edit(const Json& json, const DocumentPlace& place, v1::Edit& out) {
  if (object_of(json, place).size() != 1)
    throw error::wrong_kind(place, "an object with one kind of edit",
                            std::to_string(object_of(json, place).size()) + " fields");
  const auto text = [](std::string* to) {
    return [to](const Json& j, const DocumentPlace& p) { *to = string_of(j, p); };
  };
  // What an edit is about is named before its fields are read, for the sake of their errors.
  const auto about = [](const Json& j, DocumentPlace p) {
    p.path.clear();
    if (const Json* feature = member(j, "feature"))
      if (const auto* id = std::get_if<std::string>(&feature->value)) p.feature = *id;
    return p;
  };
  read_fields(json, place,
              {{"setParameter",
                [&](const Json& j, const DocumentPlace& p) {
                  v1::SetParameter& edit = *out.mutable_set_parameter();
                  for (const char* field : {"name", "value"}) require(j, p, field);
                  read_fields(j, p,
                              {{"name", text(edit.mutable_name())},
                               {"value", [&](const Json& v, const DocumentPlace& q) {
                                  read_scalar(v, q, *edit.mutable_value());
                                }}});
                }},
               {"setFeatureParameter",
                [&](const Json& j, const DocumentPlace& p) {
                  v1::SetFeatureParameter& edit = *out.mutable_set_feature_parameter();
                  for (const char* field : {"feature", "name", "value"}) require(j, p, field);
                  read_fields(j, about(j, p),
                              {{"feature", text(edit.mutable_feature())},
                               {"name", text(edit.mutable_name())},
                               {"value", [&](const Json& v, const DocumentPlace& q) {
                                  read_value(v, q, *edit.mutable_value());
                                }}});
                }},
               {"setPlacement",
                [&](const Json& j, const DocumentPlace& p) {
                  v1::SetPlacement& edit = *out.mutable_set_placement();
                  for (const char* field : {"feature", "placement"}) require(j, p, field);
                  read_fields(j, about(j, p),
                              {{"feature", text(edit.mutable_feature())},
                               {"placement", [&](const Json& v, const DocumentPlace& q) {
                                  read_placement(v, q, *edit.mutable_placement());
                                }}});
                }},
               {"addFeature",
                [&](const Json& j, const DocumentPlace& p) {
                  v1::AddFeature& edit = *out.mutable_add_feature();
                  require(j, p, "feature");
                  read_fields(j, p,
                              {{"feature",
                                [&](const Json& v, const DocumentPlace& q) {
                                  read_feature(v, q, *edit.mutable_feature());
                                }},
                               {"after", text(edit.mutable_after())}});
                }},
               {"removeFeature", [&](const Json& j, const DocumentPlace& p) {
                  require(j, p, "feature");
                  read_fields(j, about(j, p),
                              {{"feature", text(out.mutable_remove_feature()->mutable_feature())}});
                }}});
}

void read_edits(const Json& json, v1::ModelEdit& out) {
  require(json, {}, "edits");
  read_fields(json, {}, {{"edits", [&](const Json& j, const DocumentPlace& p) {
                            const Json::List& list = list_of(j, p);
                            for (std::size_t i = 0; i < list.size(); ++i) {
                              DocumentPlace place = entry(p, i);
                              place.edit_index = static_cast<int>(i);
                              read_edit(list[i], place, *out.add_edits());
                            }
                          }}});
}

}  // namespace

std::string read_document(const std::filesystem::path& file, const DocumentLimits& limits) {
  std::error_code failure;
  if (std::filesystem::is_directory(file, failure))
    throw error::document_unreadable(file.string(), "it is a directory");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw error::document_unreadable(file.string(), std::strerror(errno));
  const auto size = std::filesystem::file_size(file, failure);
  if (!failure && size > limits.bytes) throw error::document_too_large(size, limits.bytes);
  // A pipe tells no size: never take more than one byte over the limit.
  std::string text(limits.bytes + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.bad()) throw error::document_unreadable(file.string(), std::strerror(errno));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() > limits.bytes) throw error::document_too_large(text.size(), limits.bytes);
  return text;
}

v1::FeatureModel parse_model(std::string_view text, const DocumentLimits& limits) {
  v1::FeatureModel model;
  read_model(read_json(text, limits), model);
  return model;
}

v1::ModelEdit parse_edit(std::string_view text, const DocumentLimits& limits) {
  v1::ModelEdit edit;
  read_edits(read_json(text, limits), edit);
  return edit;
}

std::variant<v1::FeatureModel, v1::ModelEdit> parse_document(std::string_view text,
                                                             const DocumentLimits& limits) {
  const Json json = read_json(text, limits);
  if (member(json, "edits") != nullptr) {
    v1::ModelEdit edit;
    read_edits(json, edit);
    return edit;
  }
  v1::FeatureModel model;
  read_model(json, model);
  return model;
}

}  // namespace remeshd
