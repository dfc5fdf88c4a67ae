#include "tests/support/cases.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace remeshd::test {
namespace {

using nlohmann::json;

json read_json(const std::string& file) {
  const std::string path = std::string(REMESHD_CASES_DIR) + "/" + file;
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot open " + path);
  return json::parse(in);
}

Scalar scalar(const json& j) {
  if (j.is_string()) return j.get<std::string>();
  return j.get<double>();
}

std::array<Scalar, 3> triple(const json& j) {
  return {scalar(j.at(0)), scalar(j.at(1)), scalar(j.at(2))};
}

std::map<std::string, Scalar> scalars(const json& j) {
  std::map<std::string, Scalar> result;
  for (const auto& [name, value] : j.items())
    if (!value.is_array()) result[name] = scalar(value);
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
  throw std::runtime_error("unknown edit " + kind);
}

}  // namespace

ModelSource case_model(const std::string& name) {
  const json j = read_json(name + ".json");
  ModelSource model;
  model.name = j.at("name").get<std::string>();
  model.unit = j.value("unit", std::string());
  if (j.contains("parameters")) model.parameters = scalars(j.at("parameters"));
  for (const json& f : j.at("features")) model.features.push_back(feature_of(f));
  return model;
}

ModelEdit case_edit(const std::string& name) {
  const json j = read_json(name + ".edit.json");
  ModelEdit edit;
  for (const json& one : j.at("edits")) edit.edits.push_back(edit_of(one));
  return edit;
}

FeatureModel case_features(const std::string& name) { return evaluate(case_model(name)); }

const std::vector<EditCase>& seven_cases() {
  static const std::vector<EditCase> cases{
      {"simple-a", "simple-ab", "simple-b", 258000, 258000},
      {"tool1-a", "tool1-ab", "tool1-b", 109525.344682, 113295.255866},
      {"tool1-a", "tool1-ac", "tool1-c", 109525.344682, 109525.344682},
      {"tool2-a", "tool2-ab", "tool2-b", 163263.715790, 172863.715790},
      {"tool2-b", "tool2-bc", "tool2-c", 172863.715790, 172863.715790},
      {"tool2-c", "tool2-cd", "tool2-d", 172863.715790, 172779.646351},
      {"tool3-a", "tool3-ab", "tool3-b", 113927.875959, 173327.875959},
  };
  return cases;
}

ModelSource one_feature(FeatureSource only) {
  ModelSource model;
  model.name = "one";
  model.unit = "mm";
  model.features.push_back(std::move(only));
  return model;
}

FeatureSource feature(std::string id, std::string type, std::map<std::string, Scalar> parameters) {
  FeatureSource result;
  result.id = std::move(id);
  result.type = std::move(type);
  result.parameters = std::move(parameters);
  return result;
}

FeatureSource feature(std::string id, std::string type, std::vector<ProfileEntry> outline,
                      std::map<std::string, Scalar> parameters) {
  FeatureSource result = feature(std::move(id), std::move(type), std::move(parameters));
  result.profile = std::move(outline);
  return result;
}

ProfileEntry point(Scalar x, Scalar y) { return {std::move(x), std::move(y), {}}; }

ProfileEntry arc(Scalar x, Scalar y, Scalar tx, Scalar ty) {
  return {std::move(x), std::move(y), std::array<Scalar, 2>{std::move(tx), std::move(ty)}};
}

}  // namespace remeshd::test
