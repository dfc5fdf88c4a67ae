#include <algorithm>
#include <cstddef>
#include <optional>

#include "engine/base/error.h"
#include "engine/base/text/nearest_name.h"
#include "engine/model/expression.h"
#include "engine/model/feature_model.h"
#include "engine/model/feature_types.h"
#include "engine/model/selection/selection_error.h"

namespace remeshd {
namespace {

using Position = std::vector<FeatureSource>::iterator;

Position find_feature(ModelSource& model, const std::string& id) {
  return std::find_if(model.features.begin(), model.features.end(),
                      [&](const FeatureSource& f) { return f.id == id; });
}

/// Puts the known name that may have been meant, if there is one, into the error's hint.
template <class Named, class Name>
Error with_suggestion(Error unknown, const std::string& name, const std::vector<Named>& known,
                      Name Named::*name_of) {
  std::vector<std::string> names;
  for (const Named& one : known) names.push_back(one.*name_of);
  const std::string nearest = nearest_name(name, names);
  if (!nearest.empty()) unknown.info().hint = "did you mean `" + nearest + "`?";
  return unknown;
}

Position feature_named(ModelSource& model, const std::string& id) {
  const Position found = find_feature(model, id);
  if (found == model.features.end())
    throw with_suggestion(error::unknown_feature(id), id, model.features, &FeatureSource::id);
  return found;
}

/// One overload per edit.
struct Editor {
  ModelSource& model;

  void operator()(const SetParameter& edit) const {
    const auto found = std::ranges::find(model.parameters, edit.name, &ParameterSource::name);
    if (found == model.parameters.end())
      throw with_suggestion(error::unknown_model_parameter(edit.name), edit.name, model.parameters,
                            &ParameterSource::name);
    found->value = edit.value;
  }

  void operator()(const SetFeatureParameter& edit) const {
    FeatureSource& feature = *feature_named(model, edit.feature);
    const FeatureTypeInfo* type = find_feature_type(feature.type);
    if (type == nullptr)
      throw error::unknown_feature_type(feature.id, feature.type, list_feature_types());
    const ParameterInfo* parameter = find_parameter(*type, edit.name);
    if (parameter == nullptr)
      throw with_suggestion(error::unknown_parameter(feature.id, edit.name, list_parameters(*type)),
                            edit.name, type->parameters, &ParameterInfo::name);
    const auto* scalar = std::get_if<Scalar>(&edit.value);
    if (parameter->unit == "profile") {
      if (scalar != nullptr)
        throw error::wrong_value_kind(feature.id, edit.name, "a list of points and arcs");
      feature.profile = std::get<std::vector<ProfileEntry>>(edit.value);
    } else {
      if (scalar == nullptr)
        throw error::wrong_value_kind(feature.id, edit.name, "a number or an expression");
      feature.parameters[edit.name] = *scalar;
    }
  }

  void operator()(const SetPlacement& edit) const {
    feature_named(model, edit.feature)->placement = edit.placement;
  }

  void operator()(const AddFeature& edit) const {
    check_name(edit.feature.id, edit.feature.id, "id");
    if (find_feature(model, edit.feature.id) != model.features.end())
      throw error::duplicate_feature(edit.feature.id);
    const Position place =
        edit.after.empty() ? model.features.end() : feature_named(model, edit.after) + 1;
    model.features.insert(place, edit.feature);
  }

  void operator()(const RemoveFeature& edit) const {
    model.features.erase(feature_named(model, edit.feature));
  }

  void operator()(const SetSize& edit) const {
    const auto found = std::ranges::find(model.sizes, edit.id, &SizeControlSource::id);
    if (found != model.sizes.end()) {
      if (edit.place) found->place = *edit.place;
      if (edit.size) found->size = *edit.size;
      return;
    }
    if (!edit.place) throw error::incomplete_size(edit.id, "on");
    if (!edit.size) throw error::incomplete_size(edit.id, "size");
    model.sizes.push_back({edit.id, *edit.place, *edit.size});
  }

  void operator()(const RemoveSize& edit) const {
    const auto found = std::ranges::find(model.sizes, edit.id, &SizeControlSource::id);
    if (found == model.sizes.end())
      throw with_suggestion(error::unknown_size(edit.id), edit.id, model.sizes,
                            &SizeControlSource::id);
    model.sizes.erase(found);
  }

  void operator()(const SetGroup& edit) const {
    const auto found = std::ranges::find(model.groups, edit.name, &GroupSource::name);
    if (found != model.groups.end()) {
      if (edit.on) found->on = *edit.on;
      if (edit.policy) found->policy = *edit.policy;
      return;
    }
    if (!edit.on) throw error::incomplete_group(edit.name);
    model.groups.push_back({edit.name, *edit.on, edit.policy.value_or(GroupPolicy{})});
  }

  void operator()(const RemoveGroup& edit) const {
    const auto found = std::ranges::find(model.groups, edit.name, &GroupSource::name);
    if (found == model.groups.end())
      throw with_suggestion(error::unknown_group(edit.name), edit.name, model.groups,
                            &GroupSource::name);
    model.groups.erase(found);
  }
};

/// Whether the document, after the first `count` edits, evaluates with this error.
bool has_error(const ModelSource& source, const ModelEdit& edit, std::size_t count,
               const ErrorInfo& failure) {
  try {
    evaluate(apply(source, {{edit.edits.begin(), edit.edits.begin() + static_cast<int>(count)}}));
    return false;
  } catch (const Error& now) {
    return now.info().reason == failure.reason && now.info().features == failure.features &&
           now.info().parameter == failure.parameter;
  }
}

/// Finds by bisection the index of an edit that brings in the error which the document has after
/// all edits; nothing where the document has the error without them.
std::optional<int> edit_at_fault(const ModelSource& source, const ModelEdit& edit,
                                 const ErrorInfo& failure) {
  if (edit.edits.empty() || has_error(source, edit, 0, failure)) return {};
  std::size_t without = 0, with = edit.edits.size();
  while (with - without > 1) {
    const std::size_t middle = (without + with) / 2;
    (has_error(source, edit, middle, failure) ? with : without) = middle;
  }
  return static_cast<int>(without);
}

}  // namespace

ModelSource apply(const ModelSource& source, const ModelEdit& edit) {
  ModelSource result = source;
  for (std::size_t k = 0; k < edit.edits.size(); ++k) {
    try {
      std::visit(Editor{result}, edit.edits[k]);
    } catch (Error& failure) {
      failure.info().edit_index = static_cast<int>(k);
      throw;
    }
  }
  return result;
}

EvaluatedModel evaluate_edited(const ModelSource& source, const ModelEdit& edit) {
  EvaluatedModel edited{.source = apply(source, edit), .model = {}};
  try {
    edited.model = evaluate(edited.source);
  } catch (Error& failure) {
    failure.info().edit_index = edit_at_fault(source, edit, failure.info());
    throw;
  }
  return edited;
}

}  // namespace remeshd
