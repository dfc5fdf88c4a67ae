#include <cmath>

#include "engine/base/tolerance.h"
#include "engine/model/expression.h"
#include "engine/model/feature_model.h"
#include "engine/model/solid.h"

namespace remeshd {
namespace {

/// The feature with numbers in the place of expressions.
FeatureSource in_numbers(FeatureSource feature, const Scope& scope) {
  const auto evaluate = [&](Scalar& scalar) { scalar = scope.value(scalar, feature.id, ""); };
  const auto evaluate_all = [&](auto& scalars) {
    for (Scalar& scalar : scalars) evaluate(scalar);
  };
  for (auto& [name, value] : feature.parameters) evaluate(value);
  if (feature.profile)
    for (ProfileEntry& entry : *feature.profile) {
      evaluate(entry.x);
      evaluate(entry.y);
      if (entry.through) evaluate_all(*entry.through);
    }
  evaluate_all(feature.placement.origin);
  if (feature.placement.z_axis) evaluate_all(*feature.placement.z_axis);
  if (feature.placement.x_axis) evaluate_all(*feature.placement.x_axis);
  if (auto* point = std::get_if<std::array<Scalar, 3>>(&feature.reference)) evaluate_all(*point);
  return feature;
}

}  // namespace

TinyMotions without_tiny_motions(const ModelSource& source, const ModelSource& meshed) {
  TinyMotions result{source, {}};
  if (source == meshed) return result;
  const FeatureModel now = evaluate(source), then = evaluate(meshed);
  const double diagonal = additive_bounds(now).diagonal();
  const Scope scope(meshed.parameters);
  for (std::size_t k = 0; k < now.features.size(); ++k) {
    const int before = then.index_of(now.features[k].id);
    if (before < 0) continue;
    const double motion = motion_bound(then.features[before], now.features[k]);
    if (motion <= tolerance::kRounding * diagonal || motion > tolerance::kTinyMotion * diagonal)
      continue;
    result.source.features[k] = in_numbers(meshed.features[before], scope);
    result.features.push_back(now.features[k].id);
  }
  return result;
}

}  // namespace remeshd
