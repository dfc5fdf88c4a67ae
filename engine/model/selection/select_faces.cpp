#include "engine/model/selection/select_faces.h"

#include <algorithm>

#include "engine/base/error.h"
#include "engine/model/expression.h"
#include "engine/model/feature_types.h"
#include "engine/model/solid.h"

namespace remeshd {
namespace {

/// The faces of a feature that a term names, each once.
std::vector<std::string> named_by(const SelectorTerm& term, const Feature& feature) {
  std::vector<std::string> names;
  for (const SolidFace& face : faces_of(feature))
    if (term.names(feature.id, face.name) && std::ranges::find(names, face.name) == names.end())
      names.push_back(face.name);
  return names;
}

}  // namespace

std::map<std::string, double> numbers_of(const FeatureSource& feature, const Scope& scope) {
  std::map<std::string, double> numbers;
  for (const auto& [name, value] : feature.parameters)
    numbers[name] = scope.value(value, feature.id, name);
  if (const FeatureTypeInfo* type = find_feature_type(feature.type))
    for (const ParameterInfo& info : type->parameters)
      if (!info.default_value.empty() && !numbers.contains(info.name))
        numbers[info.name] = scope.value(info.default_value, feature.id, info.name);
  return numbers;
}

std::vector<SelectedFaces> select_faces(std::string_view selector, const ModelSource& source,
                                        const std::vector<Feature>& features, const Scope& scope,
                                        const std::string& parameter, SelectorCost& cost) {
  const std::vector<SelectorTerm> terms = read_selector(selector, parameter);
  cost.questions += terms.size() * features.size();
  if (cost.questions > kSelectorLimits.questions)
    throw error::limit_exceeded("", parameter, "terms of selectors, times features,",
                                cost.questions, kSelectorLimits.questions);
  std::vector<SelectedFaces> selected;
  for (std::size_t k = 0; k < features.size(); ++k) {
    SelectedFaces everywhere{
        .feature = static_cast<int>(k), .faces = {}, .whole = false, .condition = {}};
    std::vector<SelectedFaces> conditional;
    for (const SelectorTerm& term : terms) {
      std::vector<std::string> names = named_by(term, features[k]);
      if (names.empty()) continue;
      const bool whole = term.names(features[k].id);
      if (term.condition.empty()) {
        everywhere.whole |= whole;
        for (std::string& name : names)
          if (std::ranges::find(everywhere.faces, name) == everywhere.faces.end())
            everywhere.faces.push_back(std::move(name));
        continue;
      }
      if (++cost.conditions > kSelectorLimits.conditions)
        throw error::limit_exceeded("", parameter, "conditions of selectors, times features,",
                                    cost.conditions, kSelectorLimits.conditions);
      const FeatureSource& feature = source.features[k];
      conditional.push_back(
          {.feature = static_cast<int>(k),
           .faces = std::move(names),
           .whole = whole,
           .condition = scope.open(term.condition, kPlaceNames, numbers_of(feature, scope),
                                   feature.id, parameter)});
    }
    if (!everywhere.faces.empty()) selected.push_back(std::move(everywhere));
    std::ranges::move(conditional, std::back_inserter(selected));
  }
  return selected;
}

}  // namespace remeshd
