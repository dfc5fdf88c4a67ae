#include "engine/model/selection/select_faces.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>

#include "engine/base/error.h"
#include "engine/model/expression.h"
#include "engine/model/feature_types.h"
#include "engine/model/solid.h"

namespace remeshd {
namespace {

/// The names of a feature's faces, each once.
std::vector<std::string> face_names(const Feature& feature) {
  std::vector<std::string> names;
  std::set<std::string_view> seen;
  const std::vector<SolidFace> faces = faces_of(feature);
  for (const SolidFace& face : faces)
    if (seen.insert(face.name).second) names.push_back(face.name);
  return names;
}

/// Those of the names, of faces of a feature, that a term selects.
std::vector<std::string> selected_by(const SelectorTerm& term, const std::string& feature,
                                     const std::vector<std::string>& names) {
  std::vector<std::string> selected;
  std::ranges::copy_if(names, std::back_inserter(selected),
                       [&](const std::string& name) { return term.names(feature, name); });
  return selected;
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
    const std::vector<std::string> all = face_names(features[k]);
    std::set<std::string> named_everywhere;
    for (const SelectorTerm& term : terms) {
      std::vector<std::string> names = selected_by(term, features[k].id, all);
      if (names.empty()) continue;
      const bool whole = term.names(features[k].id);
      if (term.condition.empty()) {
        everywhere.whole |= whole;
        for (std::string& name : names)
          if (named_everywhere.insert(name).second) everywhere.faces.push_back(std::move(name));
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
