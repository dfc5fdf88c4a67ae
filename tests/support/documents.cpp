#include "tests/support/documents.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/support/cases.h"

namespace remeshd::test {
namespace {

using nlohmann::json;

Scalar scalar(const json& j) {
  if (j.is_string()) return j.get<std::string>();
  return j.get<double>();
}

template <std::size_t n>
std::array<Scalar, n> tuple(const json& j) {
  std::array<Scalar, n> result;
  for (std::size_t k = 0; k < n; ++k) result[k] = scalar(j.at(k));
  return result;
}

std::array<Scalar, 3> triple(const json& j) { return tuple<3>(j); }

std::map<std::string, Scalar> scalars(const json& j) {
  std::map<std::string, Scalar> result;
  for (const auto& [name, value] : j.items())
    if (!value.is_array()) result[name] = scalar(value);
  return result;
}

/// `4`, or `{"value": 4, "lower": 1, "upper": 8}`.
ParameterSource parameter_of(const std::string& name, const json& j) {
  if (!j.is_object()) return {.name = name, .value = scalar(j)};
  ParameterSource result{.name = name, .value = scalar(j.at("value"))};
  if (j.contains("lower")) result.lower = j.at("lower").get<double>();
  if (j.contains("upper")) result.upper = j.at("upper").get<double>();
  result.integer = j.value("integer", false);
  result.unit = j.value("unit", std::string());
  result.description = j.value("description", std::string());
  return result;
}

std::vector<ProfileEntry> profile(const json& j) {
  std::vector<ProfileEntry> result;
  for (const json& entry : j) {
    if (entry.is_array()) {
      result.push_back(point(scalar(entry.at(0)), scalar(entry.at(1))));
      continue;
    }
    const json& to = entry.at("to");
    const json& through = entry.at("through");
    result.push_back(
        arc(scalar(to.at(0)), scalar(to.at(1)), scalar(through.at(0)), scalar(through.at(1))));
  }
  return result;
}

PlacementSource placement(const json& j) {
  PlacementSource result;
  if (j.contains("origin")) result.origin = triple(j.at("origin"));
  if (j.contains("zAxis")) result.z_axis = triple(j.at("zAxis"));
  if (j.contains("xAxis")) result.x_axis = triple(j.at("xAxis"));
  return result;
}

FeatureSource feature_of(const json& j) {
  FeatureSource result;
  result.id = j.at("id").get<std::string>();
  result.nature = j.at("nature") == "SUBTRACTIVE" ? Nature::Subtractive : Nature::Additive;
  result.type = j.at("type").get<std::string>();
  result.parameters = scalars(j.at("parameters"));
  if (j.at("parameters").contains("profile"))
    result.profile = profile(j.at("parameters").at("profile"));
  if (j.contains("placement")) result.placement = placement(j.at("placement"));
  if (j.contains("reference") && j.at("reference") == "CENTRE")
    result.reference = ReferenceKind::Centre;
  if (j.contains("referencePoint")) result.reference = triple(j.at("referencePoint"));
  return result;
}

/// Where a size control holds; nothing where an edit leaves that as it is.
std::optional<SizePlaceSource> size_place(const json& j) {
  if (j.contains("on")) return j.at("on").get<std::string>();
  if (!j.contains("in")) return std::nullopt;
  const json& region = j.at("in");
  if (region.contains("ball")) return tuple<4>(region.at("ball"));
  return tuple<6>(region.at("box"));
}

SizeControlSource size_of(const json& j) {
  return {j.at("id").get<std::string>(), size_place(j).value(), scalar(j.at("size"))};
}

SetSize set_size(const json& j) {
  SetSize edit{.id = j.at("id").get<std::string>(), .place = size_place(j)};
  if (j.contains("size")) edit.size = scalar(j.at("size"));
  return edit;
}

GroupPolicy policy_of(const json& j) {
  GroupPolicy policy;
  if (j.contains("maxAreaChange")) policy.max_area_change = j.at("maxAreaChange").get<double>();
  policy.fail_emptied = j.value("onEmptied", "warn") == "fail";
  return policy;
}

GroupSource group_of(const std::string& name, const json& j) {
  if (j.is_string()) return {name, j.get<std::string>(), {}};
  return {name, j.at("on").get<std::string>(),
          j.contains("policy") ? policy_of(j.at("policy")) : GroupPolicy{}};
}

SetGroup set_group(const json& j) {
  SetGroup edit{.name = j.at("name").get<std::string>()};
  if (j.contains("on")) edit.on = j.at("on").get<std::string>();
  if (j.contains("policy")) edit.policy = policy_of(j.at("policy"));
  return edit;
}

Edit edit_of(const json& j) {
  const json& body = j.begin().value();
  const std::string& kind = j.begin().key();
  if (kind == "setParameter")
    return SetParameter{body.at("name").get<std::string>(), scalar(body.at("value"))};
  if (kind == "setFeatureParameter") {
    SetFeatureParameter edit{
        body.at("feature").get<std::string>(), body.at("name").get<std::string>(), {}};
    if (body.at("value").is_array())
      edit.value = profile(body.at("value"));
    else
      edit.value = scalar(body.at("value"));
    return edit;
  }
  if (kind == "setPlacement")
    return SetPlacement{body.at("feature").get<std::string>(), placement(body.at("placement"))};
  if (kind == "addFeature")
    return AddFeature{feature_of(body.at("feature")), body.value("after", std::string())};
  if (kind == "removeFeature") return RemoveFeature{body.at("feature").get<std::string>()};
  if (kind == "setSize") return set_size(body);
  if (kind == "removeSize") return RemoveSize{body.at("id").get<std::string>()};
  if (kind == "setGroup") return set_group(body);
  if (kind == "removeGroup") return RemoveGroup{body.at("name").get<std::string>()};
  throw std::runtime_error("unknown edit " + kind);
}

json to_json(const Scalar& s) {
  return std::visit([](const auto& value) { return json(value); }, s);
}

template <std::size_t n>
json to_json(const std::array<Scalar, n>& values) {
  json result = json::array();
  for (const Scalar& value : values) result.push_back(to_json(value));
  return result;
}

json to_json(const std::vector<ProfileEntry>& outline) {
  json result = json::array();
  for (const ProfileEntry& entry : outline) {
    const json to = json::array({to_json(entry.x), to_json(entry.y)});
    if (!entry.through) {
      result.push_back(to);
      continue;
    }
    const json through = json::array({to_json((*entry.through)[0]), to_json((*entry.through)[1])});
    result.push_back({{"to", to}, {"through", through}});
  }
  return result;
}

json to_json(const PlacementSource& p) {
  json result{{"origin", to_json(p.origin)}};
  if (p.z_axis) result["zAxis"] = to_json(*p.z_axis);
  if (p.x_axis) result["xAxis"] = to_json(*p.x_axis);
  return result;
}

json to_json(const ParameterSource& p) {
  const bool only_a_value = p == ParameterSource{.name = p.name, .value = p.value};
  if (only_a_value) return to_json(p.value);
  json result{{"value", to_json(p.value)}};
  if (p.lower) result["lower"] = *p.lower;
  if (p.upper) result["upper"] = *p.upper;
  if (p.integer) result["integer"] = true;
  if (!p.unit.empty()) result["unit"] = p.unit;
  if (!p.description.empty()) result["description"] = p.description;
  return result;
}

json to_json(const FeatureSource& f) {
  json parameters = json::object();
  for (const auto& [name, value] : f.parameters) parameters[name] = to_json(value);
  if (f.profile) parameters["profile"] = to_json(*f.profile);
  json result{{"id", f.id},
              {"nature", f.nature == Nature::Additive ? "ADDITIVE" : "SUBTRACTIVE"},
              {"type", f.type},
              {"parameters", parameters},
              {"placement", to_json(f.placement)}};
  if (const auto* point = std::get_if<std::array<Scalar, 3>>(&f.reference))
    result["referencePoint"] = to_json(*point);
  else if (std::get<ReferenceKind>(f.reference) == ReferenceKind::Centre)
    result["reference"] = "CENTRE";
  return result;
}

void put(const SizePlaceSource& place, json& size) {
  if (const auto* on = std::get_if<std::string>(&place)) {
    size["on"] = *on;
  } else if (const auto* ball = std::get_if<BallSource>(&place)) {
    size["in"] = {{"ball", to_json(*ball)}};
  } else {
    size["in"] = {{"box", to_json(std::get<BoxSource>(place))}};
  }
}

json to_json(const SizeControlSource& s) {
  json result{{"id", s.id}, {"size", to_json(s.size)}};
  put(s.place, result);
  return result;
}

json to_json(const GroupPolicy& policy) {
  json result{{"onEmptied", policy.fail_emptied ? "fail" : "warn"}};
  if (policy.max_area_change) result["maxAreaChange"] = *policy.max_area_change;
  return result;
}

json to_json(const GroupSource& group) {
  if (group.policy == GroupPolicy{}) return group.on;
  return {{"on", group.on}, {"policy", to_json(group.policy)}};
}

/// One overload per edit.
struct EditWriter {
  json operator()(const SetParameter& edit) const {
    return {{"setParameter", {{"name", edit.name}, {"value", to_json(edit.value)}}}};
  }
  json operator()(const SetFeatureParameter& edit) const {
    const json value = std::visit([](const auto& v) { return to_json(v); }, edit.value);
    return {{"setFeatureParameter",
             {{"feature", edit.feature}, {"name", edit.name}, {"value", value}}}};
  }
  json operator()(const SetPlacement& edit) const {
    return {{"setPlacement", {{"feature", edit.feature}, {"placement", to_json(edit.placement)}}}};
  }
  json operator()(const AddFeature& edit) const {
    json body{{"feature", to_json(edit.feature)}};
    if (!edit.after.empty()) body["after"] = edit.after;
    return {{"addFeature", body}};
  }
  json operator()(const RemoveFeature& edit) const {
    return {{"removeFeature", {{"feature", edit.feature}}}};
  }
  json operator()(const SetSize& edit) const {
    json body{{"id", edit.id}};
    if (edit.place) put(*edit.place, body);
    if (edit.size) body["size"] = to_json(*edit.size);
    return {{"setSize", body}};
  }
  json operator()(const RemoveSize& edit) const { return {{"removeSize", {{"id", edit.id}}}}; }
  json operator()(const SetGroup& edit) const {
    json body{{"name", edit.name}};
    if (edit.on) body["on"] = *edit.on;
    if (edit.policy) body["policy"] = to_json(*edit.policy);
    return {{"setGroup", body}};
  }
  json operator()(const RemoveGroup& edit) const {
    return {{"removeGroup", {{"name", edit.name}}}};
  }
};

}  // namespace

ModelSource read_model(const json& j) {
  ModelSource model;
  model.name = j.at("name").get<std::string>();
  model.unit = j.value("unit", std::string());
  if (j.contains("parameters"))
    for (const auto& [name, value] : j.at("parameters").items())
      model.parameters.push_back(parameter_of(name, value));
  for (const json& f : j.at("features")) model.features.push_back(feature_of(f));
  if (j.contains("sizes"))
    for (const json& s : j.at("sizes")) model.sizes.push_back(size_of(s));
  if (j.contains("groups"))
    for (const auto& [name, group] : j.at("groups").items())
      model.groups.push_back(group_of(name, group));
  return model;
}

ModelEdit read_edit(const json& j) {
  ModelEdit edit;
  for (const json& one : j.at("edits")) edit.edits.push_back(edit_of(one));
  return edit;
}

json write_model(const ModelSource& model) {
  json parameters = json::object();
  for (const ParameterSource& p : model.parameters) parameters[p.name] = to_json(p);
  json features = json::array();
  for (const FeatureSource& f : model.features) features.push_back(to_json(f));
  json result{{"name", model.name}, {"parameters", parameters}, {"features", features}};
  if (!model.unit.empty()) result["unit"] = model.unit;
  for (const SizeControlSource& s : model.sizes) result["sizes"].push_back(to_json(s));
  for (const GroupSource& g : model.groups) result["groups"][g.name] = to_json(g);
  return result;
}

json write_edit(const ModelEdit& edit) {
  json edits = json::array();
  for (const Edit& one : edit.edits) edits.push_back(std::visit(EditWriter{}, one));
  return {{"edits", edits}};
}

}  // namespace remeshd::test
