#include "engine/delivery/group_outcomes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include "engine/cellular/boundary_model/face_part.h"
#include "engine/model/selection/selected_material.h"
#include "engine/model/selection/selection_error.h"
#include "engine/model/solid.h"
#include "engine/revision/group_figures.h"

namespace remeshd {
namespace {

struct GroupLimits {
  // Relative: how far areas are apart that are the same but for rounding, or for the quadrature of
  // conditions.
  double rounding = 1e-6, quadrature = 5e-4;
};
constexpr GroupLimits kGroupLimits;

/// The parts of a group's selector that name a face of the boundary.
std::vector<const SelectedFaces*> selected_on(const BoundaryFace& face, const FaceGroup& group) {
  std::vector<const SelectedFaces*> found;
  for (const SelectedFaces& on : group.on)
    if (std::ranges::any_of(face.names, [&](const FaceName& name) {
          return name.feature == on.feature &&
                 std::ranges::find(on.faces, name.face) != on.faces.end();
        }))
      found.push_back(&on);
  return found;
}

/// Area that a group selects of a face.
double area_on(const BoundaryFace& face, const FaceGroup& group, const Run& run) {
  const std::vector<const SelectedFaces*> selected = selected_on(face, group);
  if (selected.empty()) return 0;
  std::vector<ConditionTest> conditions;
  for (const SelectedFaces* on : selected) {
    if (on->condition.text.empty()) return face.area;
    conditions.emplace_back(on->condition);
  }
  const PlaceTest holds = [&](const Vec3& p, const Vec3& normal) {
    Held held{.holds = false, .margin = -HUGE_VAL};
    for (ConditionTest& test : conditions) {
      held.holds = held.holds || test(p, normal);
      const double margin = test.margin(p, normal);
      if (!(margin <= held.margin)) held.margin = std::isnan(held.margin) ? held.margin : margin;
    }
    return held;
  };
  return area_where(face, holds, run);
}

const GroupFigures* find_group(std::span<const GroupFigures> figures, const std::string& group) {
  const auto found = std::ranges::find_if(
      figures, [&](const GroupFigures& f) { return f.of_model && f.group == group; });
  return found == figures.end() ? nullptr : &*found;
}

/// By group of the model: the other groups that it shares facets with.
std::map<std::string_view, std::set<std::string_view>> shared_facets(const MeshGroups& groups) {
  std::map<std::string_view, std::set<std::string_view>> shared;
  std::vector<std::vector<const GroupMembers*>> of_facet(
      groups.of_model.empty() ? 0 : groups.facets.size());
  for (const GroupMembers& group : groups.of_model)
    for (const std::int32_t f : group.facets) {
      for (const GroupMembers* other : of_facet[f]) {
        shared[group.name].insert(other->name);
        shared[other->name].insert(group.name);
      }
      of_facet[f].push_back(&group);
    }
  return shared;
}

/// How far areas of a group are apart, as a share, that count as the same.
double area_tolerance(const FeatureModel& model, const std::string& group) {
  const auto named = std::ranges::find(model.groups, group, &FaceGroup::name);
  const bool conditional =
      named != model.groups.end() && std::ranges::any_of(named->on, [](const SelectedFaces& on) {
        return !on.condition.text.empty();
      });
  return conditional ? kGroupLimits.quadrature : kGroupLimits.rounding;
}

bool same_area(const GroupFigures& a, const GroupFigures& b, double tolerance) {
  const bool exact = a.exact_area && b.exact_area;
  const double of_a = exact ? *a.exact_area : a.mesh_area;
  const double of_b = exact ? *b.exact_area : b.mesh_area;
  return std::fabs(of_a - of_b) <= tolerance * std::fmax(of_a, of_b);
}

GroupState state_of(const GroupFigures& now, const GroupFigures& before, bool shares_anew,
                    double tolerance) {
  const bool empty = now.facets == 0 && now.tets == 0;
  const bool was_empty = before.facets == 0 && before.tets == 0;
  if (empty) return was_empty ? GroupState::Same : GroupState::Emptied;
  if (was_empty) return GroupState::New;
  if (now.parts > before.parts) return GroupState::Split;
  if (now.parts < before.parts || shares_anew) return GroupState::Merged;
  return same_area(now, before, tolerance) ? GroupState::Same : GroupState::Resized;
}

}  // namespace

std::vector<GroupFigures> groups_before_meshing(const FeatureModel& model,
                                                const BoundaryModel& boundary, const Run& run) {
  std::vector<GroupFigures> all;
  for (const FaceGroup& group : model.groups) {
    double area = 0;
    for (const BoundaryFace& face : boundary.faces) area += area_on(face, group, run);
    all.push_back({.group = group.name, .of_model = true, .exact_area = area});
  }
  return all;
}

std::vector<std::string> groups_of_nothing(const FeatureModel& model, const BoundaryModel& boundary,
                                           const Run& run) {
  std::vector<std::string> names;
  if (model.groups.empty()) return names;
  const Membership membership(model);
  for (const FaceGroup& group : model.groups)
    if (std::ranges::none_of(boundary.faces,
                             [&](const auto& face) { return area_on(face, group, run) > 0; }) &&
        std::ranges::none_of(
            group.on, [&](const auto& on) { return has_material(on, model, membership, run); }))
      names.push_back(group.name);
  return names;
}

std::vector<GroupFigures> group_outcomes(const Revision& parent, const Revision& revision,
                                         std::span<const GroupFigures> before_meshing) {
  const bool first = parent.output.mesh.tets.empty();
  std::map<std::string_view, const GroupFigures*> before;
  for (const GroupFigures& figures : parent.report.figures) before.emplace(figures.group, &figures);
  const auto shared = shared_facets(revision.output.groups);
  const auto shared_before = shared_facets(parent.output.groups);
  const auto shares_anew = [&](const std::string& group) {
    const auto now = shared.find(group), then = shared_before.find(group);
    if (now == shared.end()) return false;
    return std::ranges::any_of(now->second, [&](std::string_view other) {
      return before.contains(other) &&
             (then == shared_before.end() || !then->second.contains(other));
    });
  };
  std::vector<GroupFigures> of_facets, of_model;
  std::set<std::string_view> told;
  const std::vector<GroupFigures> all = group_figures(revision, before_meshing);
  for (GroupFigures now : all) {
    if (const auto then = before.find(now.group); then != before.end())
      now.state = state_of(
          now, *then->second, shares_anew(now.group),
          now.of_model ? area_tolerance(revision.model, now.group) : kGroupLimits.rounding);
    else if (!first)
      now.state = GroupState::New;
    (now.of_model ? of_model : of_facets).push_back(std::move(now));
  }
  for (const GroupFigures& now : all) told.insert(now.group);
  for (const auto& [name, figures] : before)
    if (!figures->of_model && figures->facets > 0 && !told.contains(name)) {
      GroupFigures& emptied = of_facets.emplace_back();
      emptied.group = name;
      emptied.state = GroupState::Emptied;
      emptied.exact_area = 0;
    }
  of_facets.insert(of_facets.end(), of_model.begin(), of_model.end());
  return of_facets;
}

void check_areas(const Revision& parent, const FeatureModel& model,
                 std::span<const GroupFigures> figures) {
  for (const FaceGroup& group : model.groups) {
    const GroupFigures* then = find_group(parent.report.figures, group.name);
    const GroupFigures* now = find_group(figures, group.name);
    if (!group.policy.max_area_change || then == nullptr || now == nullptr) continue;
    const double was = then->exact_area.value_or(0), is = now->exact_area.value_or(0);
    const double most = *group.policy.max_area_change;
    if (std::fabs(is - was) > (most + area_tolerance(model, group.name)) * was)
      throw error::area_changed(group.name, was, is, most);
  }
}

void check_emptied(const FeatureModel& model, std::span<const std::string> empty) {
  for (const FaceGroup& group : model.groups)
    if (group.policy.fail_emptied && std::ranges::find(empty, group.name) != empty.end())
      throw error::group_emptied(group.name);
}

std::vector<std::string> empty_groups(const OutputMesh& output) {
  std::vector<std::string> names;
  for (const GroupMembers& group : output.groups.of_model)
    if (group.facets.empty() && group.tets.empty()) names.push_back(group.name);
  return names;
}

}  // namespace remeshd
