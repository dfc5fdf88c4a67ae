#include "tests/support/cases.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

#include "tests/support/documents.h"

namespace remeshd::test {
namespace {

using nlohmann::json;

json read_json(const std::string& file) {
  const std::string path = std::string(REMESHD_CASES_DIR) + "/" + file;
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot open " + path);
  return json::parse(in);
}

}  // namespace

ModelSource case_model(const std::string& name) { return read_model(read_json(name + ".json")); }

ModelEdit case_edit(const std::string& name) { return read_edit(read_json(name + ".edit.json")); }

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

const std::vector<std::string>& detailed_parts() {
  static const std::vector<std::string> parts{"valve", "mount", "coldplate", "carrier"};
  return parts;
}

ModelSource one_feature(FeatureSource only) { return model_of({std::move(only)}); }

ModelSource model_of(std::vector<FeatureSource> features) {
  ModelSource model;
  model.name = "test";
  model.unit = "mm";
  model.features = std::move(features);
  return model;
}

Scalar& parameter(ModelSource& model, const std::string& name) {
  const auto found = std::ranges::find(model.parameters, name, &ParameterSource::name);
  if (found == model.parameters.end()) throw std::runtime_error("no parameter " + name);
  return found->value;
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

FeatureSource block(std::string id, double dx, double dy, double dz) {
  return feature(std::move(id), "block", {{"dx", dx}, {"dy", dy}, {"dz", dz}});
}

FeatureSource cylinder(std::string id, double radius, double height) {
  return feature(std::move(id), "cylinder", {{"radius", radius}, {"height", height}});
}

FeatureSource placed(FeatureSource feature, double x, double y, double z, Nature nature) {
  feature.placement.origin = {x, y, z};
  feature.nature = nature;
  return feature;
}

FeatureSource turned(FeatureSource feature, std::array<double, 3> z, std::array<double, 3> x) {
  feature.placement.z_axis = {z[0], z[1], z[2]};
  feature.placement.x_axis = {x[0], x[1], x[2]};
  return feature;
}

std::vector<int> all_of(const FeatureModel& model) {
  std::vector<int> features(model.features.size());
  std::iota(features.begin(), features.end(), 0);
  return features;
}

ProfileEntry point(Scalar x, Scalar y) { return {std::move(x), std::move(y), {}}; }

ProfileEntry arc(Scalar x, Scalar y, Scalar tx, Scalar ty) {
  return {std::move(x), std::move(y), std::array<Scalar, 2>{std::move(tx), std::move(ty)}};
}

}  // namespace remeshd::test
