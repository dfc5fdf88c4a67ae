#include "client/cli/with_edit.h"

#include <algorithm>
#include <string>

namespace remeshd::cli {
namespace {

using remesh::v1::AddFeature;
using remesh::v1::Edit;
using remesh::v1::Feature;
using remesh::v1::FeatureModel;
using remesh::v1::Group;
using remesh::v1::SetFeatureParameter;
using remesh::v1::SizeControl;

/// The first item whose `name` is that; null where there is none.
template <class List, class Name>
auto* find(List* list, Name name, const std::string& wanted) {
  const auto found =
      std::ranges::find_if(*list, [&](const auto& item) { return (item.*name)() == wanted; });
  return found == list->end() ? nullptr : &*found;
}

template <class List, class Name>
void remove(List* list, Name name, const std::string& wanted) {
  const auto found =
      std::ranges::find_if(*list, [&](const auto& item) { return (item.*name)() == wanted; });
  if (found != list->end()) list->erase(found);
}

void set(FeatureModel& model, const SetFeatureParameter& edit) {
  Feature* const feature = find(model.mutable_features(), &Feature::id, edit.feature());
  if (feature == nullptr) return;
  if (auto* const parameter =
          find(feature->mutable_parameters(), &remesh::v1::FeatureParameter::name, edit.name()))
    *parameter->mutable_value() = edit.value();
}

void add(FeatureModel& model, const AddFeature& edit) {
  auto& features = *model.mutable_features();
  const auto before = std::ranges::find(features, edit.after(), &Feature::id);
  const auto place = before == features.end() ? features.size() : before - features.begin() + 1;
  *features.Add() = edit.feature();
  std::rotate(features.begin() + place, features.end() - 1, features.end());
}

void set(FeatureModel& model, const SizeControl& edit) {
  SizeControl* size = find(model.mutable_sizes(), &SizeControl::id, edit.id());
  if (size == nullptr) size = model.add_sizes();
  size->set_id(edit.id());
  if (edit.place_case() != SizeControl::PLACE_NOT_SET) size->clear_place();
  size->MergeFrom(edit);
}

void set(FeatureModel& model, const Group& edit) {
  Group* group = find(model.mutable_groups(), &Group::name, edit.name());
  if (group == nullptr) group = model.add_groups();
  if (edit.has_policy()) group->clear_policy();
  group->MergeFrom(edit);
}

void apply(FeatureModel& model, const Edit& edit) {
  switch (edit.edit_case()) {
    case Edit::kSetParameter:
      if (auto* const parameter = find(model.mutable_parameters(), &remesh::v1::Parameter::name,
                                       edit.set_parameter().name()))
        *parameter->mutable_value() = edit.set_parameter().value();
      return;
    case Edit::kSetFeatureParameter:
      return set(model, edit.set_feature_parameter());
    case Edit::kSetPlacement:
      if (Feature* const feature =
              find(model.mutable_features(), &Feature::id, edit.set_placement().feature()))
        *feature->mutable_placement() = edit.set_placement().placement();
      return;
    case Edit::kAddFeature:
      return add(model, edit.add_feature());
    case Edit::kRemoveFeature:
      return remove(model.mutable_features(), &Feature::id, edit.remove_feature().feature());
    case Edit::kSetSize:
      return set(model, edit.set_size());
    case Edit::kRemoveSize:
      return remove(model.mutable_sizes(), &SizeControl::id, edit.remove_size().id());
    case Edit::kSetGroup:
      return set(model, edit.set_group());
    case Edit::kRemoveGroup:
      return remove(model.mutable_groups(), &Group::name, edit.remove_group().name());
    case Edit::EDIT_NOT_SET:
      return;
  }
}

}  // namespace

FeatureModel with_edit(FeatureModel model, const remesh::v1::ModelEdit& edits) {
  for (const Edit& edit : edits.edits()) apply(model, edit);
  return model;
}

}  // namespace remeshd::cli
