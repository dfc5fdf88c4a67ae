#include "engine/delivery/lost_names.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "engine/delivery/group_outcomes.h"
#include "engine/model/solid.h"
#include "engine/revision/group_figures.h"
#include "engine/sizing/size_controls.h"

namespace remeshd {
namespace {

using Group = std::vector<std::string>;

std::string_view feature_of(std::string_view face) { return face.substr(0, face.find('.')); }

std::string joined(const Group& names, const char* separator) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : separator) + name;
  return text;
}

using NameSet = std::set<std::string, std::less<>>;

/// What a mesh has names for.
class Names {
 public:
  explicit Names(const MeshGroups& mesh)
      : groups_(mesh.facet_groups.begin(), mesh.facet_groups.end()) {
    for (const Group& group : mesh.facet_groups)
      for (const std::string& face : group) add(face);
    for (const auto& cell : mesh.cell_owners) features_.insert(cell.begin(), cell.end());
  }

  [[nodiscard]] bool has_face(std::string_view face) const { return faces_.contains(face); }
  [[nodiscard]] bool lacks_face(std::string_view face) const { return !has_face(face); }
  /// A face or material of it.
  [[nodiscard]] bool has(std::string_view feature) const { return features_.contains(feature); }
  [[nodiscard]] bool lacks(const Feature& feature) const { return !has(feature.id); }
  [[nodiscard]] bool lacks_group(const Group& group) const { return !groups_.contains(group); }
  /// The group of the same faces in another order, if there is one.
  [[nodiscard]] Group reordered(const Group& group) const {
    for (const Group& other : groups_)
      if (std::ranges::is_permutation(other, group)) return other;
    return {};
  }

 private:
  void add(const std::string& face) {
    faces_.insert(face);
    features_.insert(std::string(feature_of(face)));
  }

  NameSet faces_, features_;
  std::set<Group> groups_;
};

/// What a mesh is certain to have names for (`has_face`), and what it is certain to have none for
/// (`lacks`), by the boundary that it will have. Of some names neither is certain.
class NamesToCome {
 public:
  NamesToCome(const FeatureModel& model, const BoundaryModel& boundary) {
    for (const BoundaryFace& face : boundary.faces) {
      NameSet names;
      for (const FaceName& name : face.names) {
        const std::string& feature = model.features[name.feature].id;
        names.insert(feature + "." + name.face);
        possible_features_.insert(feature);
      }
      possible_.insert(names.begin(), names.end());
      if (names.size() == 1) faces_.insert(*names.begin());
      together_.insert(std::move(names));
    }
  }

  [[nodiscard]] bool has_face(std::string_view face) const { return faces_.contains(face); }
  [[nodiscard]] bool lacks_face(std::string_view face) const { return !possible_.contains(face); }
  /// Certain of subtractive features without a face alone: such a one has no material unless
  /// something added later reaches into it, which `has_no_effect` rules out.
  [[nodiscard]] bool lacks(const Feature& feature) const {
    return feature.nature == Nature::Subtractive && !possible_features_.contains(feature.id);
  }
  [[nodiscard]] bool lacks_group(const Group& group) const {
    return std::ranges::none_of(together_, [&](const NameSet& names) {
      return std::ranges::all_of(group, [&](const auto& name) { return names.contains(name); });
    });
  }
  /// Empty: which face is named first in a group depends on where tets lie.
  [[nodiscard]] static Group reordered(const Group&) { return {}; }

 private:
  NameSet faces_;                         ///< on faces that have one name throughout
  NameSet possible_, possible_features_;  ///< on any face
  std::set<NameSet> together_;            ///< for each face: all its names
};

bool within(const Box& inner, const Box& outer) {
  return outer.lo.x <= inner.lo.x && inner.hi.x <= outer.hi.x && outer.lo.y <= inner.lo.y &&
         inner.hi.y <= outer.hi.y && outer.lo.z <= inner.lo.z && inner.hi.z <= outer.hi.z;
}

/// Whether a feature without any name in a mesh changes nothing at all; false where boxes do not
/// tell.
///
/// An additive one changes nothing: where it decided the nature, there would be material of it.
/// Neither does a subtractive one that no other subtractive feature and none added later comes
/// near: what it cut out of earlier features would have a face of it, unless it swallowed a whole
/// feature, which its box tells.
bool has_no_effect(const FeatureModel& model, int feature) {
  if (model.features[feature].nature == Nature::Additive) return true;
  const Box box = world_bounds(model.features[feature]);
  for (int k = 0; k < static_cast<int>(model.features.size()); ++k) {
    if (k == feature) continue;
    const Feature& other = model.features[k];
    const Box at = world_bounds(other);
    const bool earlier = other.nature == Nature::Additive && k < feature;
    if (earlier ? within(at, box) : touch(at, box)) return false;
  }
  return true;
}

Warning without_effect(const std::string& feature) {
  return {.code = WarningCode::FeatureWithoutEffect,
          .message = "the feature " + feature + " neither adds nor removes anything",
          .features = {feature}};
}

Warning face_lost(const std::string& feature, Group faces) {
  return {.code = WarningCode::FaceLost,
          .message = joined(faces, ", ") + (faces.size() > 1 ? " lie" : " lies") +
                     " nowhere on the boundary any more",
          .features = {feature},
          .groups = std::move(faces)};
}

/// `reordered`: the group that has the facets instead, empty if none does.
Warning group_emptied(const Group& group, const Group& reordered) {
  return {
      .code = WarningCode::GroupEmptied,
      .message = reordered.empty()
                     ? "no facet lies on " + joined(group, " and ") + " at the same time any more"
                     : "the group " + group_name(group) + " is called " + group_name(reordered) +
                           " now, as the order of history has it",
      .groups = {group_name(group)}};
}

/// Faces that the original's mesh names and this one does not, by feature.
template <class Now>
std::map<std::string, Group> lost_faces(const MeshGroups& original, const Now& now) {
  std::map<std::string, std::set<std::string>> lost;
  for (const Group& group : original.facet_groups)
    for (const std::string& face : group)
      if (now.lacks_face(face)) lost[std::string(feature_of(face))].insert(face);
  std::map<std::string, Group> by_feature;
  for (const auto& [feature, faces] : lost) by_feature[feature].assign(faces.begin(), faces.end());
  return by_feature;
}

bool same_features(const FeatureModel& a, const FeatureModel& b) {
  return std::ranges::equal(a.features, b.features, {}, &Feature::id, &Feature::id);
}

bool same_names(const Revision& a, const Revision& b) {
  return a.output.groups.facet_groups == b.output.groups.facet_groups &&
         a.output.groups.cell_owners == b.output.groups.cell_owners &&
         same_features(a.model, b.model);
}

/// `now`: Names, or NamesToCome of a mesh that is not there yet.
template <class Now>
std::vector<Warning> losses(const Revision& original, const FeatureModel& model, const Now& now) {
  const MeshGroups& groups_before = original.output.groups;
  const Names before(groups_before);
  std::map<std::string, Group> lost = lost_faces(groups_before, now);

  std::vector<Warning> warnings;
  for (int k = 0; k < static_cast<int>(model.features.size()); ++k) {
    const Feature& feature = model.features[k];
    const std::string& id = feature.id;
    const bool had = before.has(id) || original.model.index_of(id) < 0;
    if (had && now.lacks(feature) && has_no_effect(model, k))
      warnings.push_back(without_effect(id));
    if (auto faces = lost.extract(id))
      for (std::string& face : faces.mapped()) warnings.push_back(face_lost(id, {std::move(face)}));
  }
  // The lost faces that are left are of features that the edit removed.
  for (auto& [feature, faces] : lost) warnings.push_back(face_lost(feature, std::move(faces)));
  for (const Group& group : groups_before.facet_groups) {
    // A group that lost a face has its warning with that face.
    const bool whole =
        std::ranges::all_of(group, [&](const std::string& face) { return now.has_face(face); });
    if (!whole || group.empty() || !now.lacks_group(group)) continue;
    warnings.push_back(group_emptied(group, now.reordered(group)));
  }
  return warnings;
}

/// Appends the size controls whose selectors name nothing, neither of the boundary nor material,
/// but for those that named nothing in the original.
void add_emptied_sizes(const Revision& original, const FeatureModel& model,
                       const BoundaryModel& boundary, const Run& run,
                       std::vector<Warning>& warnings) {
  if (model.sizes.empty()) return;
  const auto before = sizes_of_nothing(original.model, original.cells.boundary, run);
  for (const std::string& size : sizes_of_nothing(model, boundary, run))
    if (std::ranges::find(before, size) == before.end())
      warnings.push_back(
          {.code = WarningCode::GroupEmptied,
           .message = "the size " + size + " selects no face of the boundary, nor material",
           .groups = {size}});
}

/// Appends the groups of the model that select nothing, but for those that did so in the original.
void add_emptied_groups(const Revision& original, std::span<const std::string> empty,
                        std::vector<Warning>& warnings) {
  const std::vector<std::string> before = empty_groups(original.output);
  for (const std::string& group : empty)
    if (std::ranges::find(before, group) == before.end())
      warnings.push_back({.code = WarningCode::GroupEmptied,
                          .message = "the group " + group + " selects nothing",
                          .groups = {group}});
}

}  // namespace

std::vector<Warning> lost_names(const Revision& original, const Revision& made, const Run& run) {
  std::vector<Warning> warnings;
  if (!same_names(original, made))
    warnings = losses(original, made.model, Names(made.output.groups));
  add_emptied_sizes(original, made.model, made.cells.boundary, run, warnings);
  add_emptied_groups(original, empty_groups(made.output), warnings);
  return warnings;
}

std::vector<Warning> names_to_be_lost(const Revision& original, const FeatureModel& model,
                                      const BoundaryModel& boundary, const Run& run) {
  std::vector<Warning> warnings = losses(original, model, NamesToCome(model, boundary));
  add_emptied_sizes(original, model, boundary, run, warnings);
  add_emptied_groups(original, groups_of_nothing(model, boundary, run), warnings);
  return warnings;
}

}  // namespace remeshd
