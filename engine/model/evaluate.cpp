#include <set>

#include "engine/base/error.h"
#include "engine/model/expression.h"
#include "engine/model/feature_model.h"
#include "engine/model/limits.h"
#include "engine/model/placement.h"
#include "engine/model/selection/evaluate_groups.h"
#include "engine/model/selection/evaluate_sizes.h"
#include "engine/model/selection/select_faces.h"
#include "engine/model/shape.h"
#include "engine/model/solid.h"

namespace remeshd {
namespace {

Vec3 evaluate_reference(const FeatureSource& source, const Shape& shape, const Scope& scope) {
  if (const auto* point = std::get_if<std::array<Scalar, 3>>(&source.reference)) {
    std::array<double, 3> v{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string place = "referencePoint[" + std::to_string(k) + "]";
      v[k] = checked_coordinate(scope.value((*point)[k], source.id, place), source.id, place);
    }
    return {v[0], v[1], v[2]};
  }
  if (std::get<ReferenceKind>(source.reference) == ReferenceKind::Origin) return {};
  const Box box = local_bounds(shape);
  return 0.5 * (box.lo + box.hi);
}

Feature evaluate_feature(const FeatureSource& source, const Scope& scope) {
  Feature feature;
  feature.id = source.id;
  feature.nature = source.nature;
  feature.shape = evaluate_shape(source, scope);
  feature.placement = evaluate_placement(source.placement, scope, source.id);
  feature.reference = evaluate_reference(source, feature.shape, scope);
  feature.alignment = feature.placement * Transform::translation(feature.reference);
  return feature;
}

}  // namespace

int FeatureModel::index_of(const std::string& id) const {
  for (std::size_t k = 0; k < features.size(); ++k)
    if (features[k].id == id) return static_cast<int>(k);
  return -1;
}

FeatureModel evaluate(const ModelSource& source) {
  if (source.features.empty()) throw error::no_features();
  if (source.features.size() > kMaxFeatures)
    throw error::limit_exceeded("", "", "features", source.features.size(), kMaxFeatures);
  const Scope scope(source.parameters);
  std::set<std::string_view> ids;
  bool any_additive = false;
  for (const FeatureSource& feature : source.features) {
    check_name(feature.id, feature.id, "id");
    if (!ids.insert(feature.id).second) throw error::duplicate_feature(feature.id);
    any_additive = any_additive || feature.nature == Nature::Additive;
  }
  if (!any_additive) throw error::no_additive_feature();

  FeatureModel model;
  model.name = source.name;
  model.features.reserve(source.features.size());
  for (const FeatureSource& feature : source.features)
    model.features.push_back(evaluate_feature(feature, scope));
  SelectorCost cost;
  model.sizes = evaluate_sizes(source, model.features, scope, cost);
  model.groups = evaluate_groups(source, model.features, scope, cost);
  return model;
}

}  // namespace remeshd
