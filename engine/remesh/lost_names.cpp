#include "engine/remesh/lost_names.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "engine/model/solid.h"
#include "engine/remesh/group_areas.h"

namespace remeshd {
namespace {

using Group = std::vector<std::string>;

std::string_view feature_of(std::string_view face) { return face.substr(0, face.find('.')); }

std::string joined(const Group& names, const char* separator) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : separator) + name;
  return text;
}

/// What a mesh has names for.
struct Names {
  std::set<std::string_view> faces, features;
  std::set<std::string_view> owners;  ///< features that material is of
  std::set<Group> groups;

  explicit Names(const MeshGroups& mesh)
      : groups(mesh.facet_groups.begin(), mesh.facet_groups.end()) {
    for (const Group& group : mesh.facet_groups)
      for (const std::string& face : group) {
        faces.insert(face);
        features.insert(feature_of(face));
      }
    for (const auto& cell : mesh.cell_owners) owners.insert(cell.begin(), cell.end());
  }
  [[nodiscard]] bool has(std::string_view feature) const {
    return features.contains(feature) || owners.contains(feature);
  }
};

bool meet(const Box& a, const Box& b) {
  return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y &&
         a.lo.z <= b.hi.z && b.lo.z <= a.hi.z;
}

bool within(const Box& inner, const Box& outer) {
  return outer.lo.x <= inner.lo.x && inner.hi.x <= outer.hi.x && outer.lo.y <= inner.lo.y &&
         inner.hi.y <= outer.hi.y && outer.lo.z <= inner.lo.z && inner.hi.z <= outer.hi.z;
}

/// Whether a feature that a mesh has no name for changes nothing at all; false where boxes do not
/// tell.
///
/// An additive one does not: where it decided, there would be material of it. Neither does a
/// subtractive one, if nothing that subtracts and nothing added later comes near it: then it would
/// cut what was added before, and that would have a face of it, unless it swallowed a whole
/// feature.
bool has_no_effect(const FeatureModel& model, int feature) {
  if (model.features[feature].nature == Nature::Additive) return true;
  const Box box = world_bounds(model.features[feature]);
  for (int k = 0; k < static_cast<int>(model.features.size()); ++k) {
    if (k == feature) continue;
    const Feature& other = model.features[k];
    const Box at = world_bounds(other);
    const bool earlier = other.nature == Nature::Additive && k < feature;
    if (earlier ? within(at, box) : meet(at, box)) return false;
  }
  return true;
}

Warning without_effect(const std::string& feature, Group lost) {
  return {.code = WarningCode::FeatureWithoutEffect,
          .message = "the feature " + feature + " neither adds nor removes anything" +
                     (lost.empty() ? "" : " any more: " + joined(lost, ", ") + " is gone"),
          .features = {feature},
          .groups = std::move(lost)};
}

Warning face_lost(const std::string& feature, Group faces) {
  return {.code = WarningCode::FaceLost,
          .message = joined(faces, ", ") + (faces.size() > 1 ? " lie" : " lies") +
                     " nowhere on the boundary any more",
          .features = {feature},
          .groups = std::move(faces)};
}

/// Faces that the original's mesh names and this one does not, by feature.
std::map<std::string, Group> lost_faces(const MeshGroups& original, const Names& now) {
  std::map<std::string, std::set<std::string>> lost;
  for (const Group& group : original.facet_groups)
    for (const std::string& face : group)
      if (!now.faces.contains(face)) lost[std::string(feature_of(face))].insert(face);
  std::map<std::string, Group> by_feature;
  for (const auto& [feature, faces] : lost) by_feature[feature].assign(faces.begin(), faces.end());
  return by_feature;
}

bool same_features(const FeatureModel& a, const FeatureModel& b) {
  return std::ranges::equal(a.features, b.features, {}, &Feature::id, &Feature::id);
}

bool same_names(const Revision& a, const Revision& b) {
  return a.delivery.groups.facet_groups == b.delivery.groups.facet_groups &&
         a.delivery.groups.cell_owners == b.delivery.groups.cell_owners &&
         same_features(a.model, b.model);
}

}  // namespace

std::vector<Warning> lost_names(const Revision* original, const Revision& made) {
  if (original && same_names(*original, made)) return {};
  const MeshGroups nothing;
  const MeshGroups& groups_before = original ? original->delivery.groups : nothing;
  const Names before(groups_before);
  const Names now(made.delivery.groups);
  std::map<std::string, Group> lost = lost_faces(groups_before, now);

  std::vector<Warning> warnings;
  for (int k = 0; k < static_cast<int>(made.model.features.size()); ++k) {
    const std::string& id = made.model.features[k].id;
    auto faces = lost.extract(id);
    const bool had = before.has(id) || !original || original->model.index_of(id) < 0;
    if (had && !now.has(id) && has_no_effect(made.model, k)) {
      warnings.push_back(without_effect(id, faces ? std::move(faces.mapped()) : Group{}));
    } else if (faces) {
      for (std::string& face : faces.mapped()) warnings.push_back(face_lost(id, {std::move(face)}));
    }
  }
  // What is left of them belongs to features that the edit removed.
  for (auto& [feature, faces] : lost) warnings.push_back(face_lost(feature, std::move(faces)));
  for (const Group& group : groups_before.facet_groups) {
    const bool told = std::ranges::any_of(
        group, [&](const std::string& face) { return !now.faces.contains(face); });
    if (told || group.empty() || now.groups.contains(group)) continue;
    warnings.push_back(
        {.code = WarningCode::GroupEmptied,
         .message = "no facet lies on " + joined(group, " and ") + " at the same time any more",
         .groups = {group_name(group)}});
  }
  return warnings;
}

}  // namespace remeshd
