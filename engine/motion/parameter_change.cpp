#include "engine/motion/parameter_change.h"

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "engine/model/expression.h"
#include "engine/model/feature_types.h"

namespace remeshd {
namespace {

struct StepLimits {
  double relative = 1e-6;  ///< x the value
  double least = 1e-3;     ///< x the model's diagonal: smaller values count as this
};
constexpr StepLimits kStep;

/// A parameter's name: `hole.radius` has a feature, `wall` has none.
struct Name {
  std::string feature, parameter;
};

Name split(const std::string& name) {
  const std::size_t dot = name.find('.');
  if (dot == std::string::npos) return {"", name};
  return {name.substr(0, dot), name.substr(dot + 1)};
}

/// The document without sizes and groups, whose parameters may take any value.
ModelSource unbound(ModelSource source) {
  for (ParameterSource& p : source.parameters) {
    p.lower.reset();
    p.upper.reset();
    p.integer = false;
  }
  source.sizes.clear();
  source.groups.clear();
  return source;
}

FeatureModel evaluated_with(const ModelSource& source, const Name& name, double value) {
  const Edit edit = name.feature.empty()
                        ? Edit(SetParameter{name.parameter, value})
                        : Edit(SetFeatureParameter{name.feature, name.parameter, Scalar(value)});
  return evaluate(apply(source, {{edit}}));
}

}  // namespace

double parameter_value(const ModelSource& source, const std::string& parameter) {
  const auto [feature, name] = split(parameter);
  const Scope scope(source.parameters);
  if (feature.empty()) {
    const auto found = std::ranges::find(source.parameters, name, &ParameterSource::name);
    if (found == source.parameters.end()) throw error::unknown_model_parameter(name);
    return scope.value(found->value, "", name);
  }
  const auto found = std::ranges::find(source.features, feature, &FeatureSource::id);
  if (found == source.features.end()) throw error::unknown_feature(feature);
  if (name == "profile") throw error::wrong_value_kind(feature, name, "one number");
  const auto value = found->parameters.find(name);
  if (value != found->parameters.end()) return scope.value(value->second, feature, name);
  const FeatureTypeInfo* type = find_feature_type(found->type);
  const ParameterInfo* left_out = type != nullptr ? find_parameter(*type, name) : nullptr;
  if (left_out == nullptr || left_out->default_value.empty())
    throw error::unknown_parameter(feature, name, type != nullptr ? list_parameters(*type) : "");
  return scope.value(left_out->default_value, feature, name);
}

FeatureModel with_value(const ModelSource& source, const std::string& parameter, double value) {
  return evaluated_with(unbound(source), split(parameter), value);
}

ParameterChange change_of(const ModelSource& source, const std::string& parameter) {
  const double value = parameter_value(source, parameter);
  const Name name = split(parameter);
  if (name.feature.empty() &&
      std::ranges::find(source.parameters, name.parameter, &ParameterSource::name)->integer)
    throw error::wrong_value_kind("", parameter, "a number that may change by little");
  const ModelSource free = unbound(source);
  const FeatureModel model = evaluate(free);
  const double step =
      kStep.relative * std::max(std::fabs(value), kStep.least * additive_bounds(model).diagonal());
  ParameterChange change{model, model, 0};
  for (const int side : {-1, 1}) {
    const double at = value + side * step;
    try {
      (side < 0 ? change.less : change.more) = evaluated_with(free, name, at);
      change.between += std::fabs(at - value);
    } catch (const Error&) {
      // One side is enough.
    }
  }
  if (change.between == 0)
    throw error::wrong_value_kind(name.feature, name.parameter,
                                  "a number that may change by little");
  return change;
}

}  // namespace remeshd
