#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/revision/revision.h"

namespace remeshd {

/// The groups of a model with the exact areas of what they select of its boundary, in their order,
/// before there is a mesh; their states are not known yet.
std::vector<GroupFigures> groups_before_meshing(const FeatureModel& model,
                                                const BoundaryModel& boundary, const Run& run);

/// Names of the groups that select nothing of the boundary and no material, in their order.
std::vector<std::string> groups_of_nothing(const FeatureModel& model, const BoundaryModel& boundary,
                                           const Run& run);

/// Figures of all groups of a finished mesh, with what became of each since the parent: first the
/// groups of facets, with those that the parent had and this mesh has not, then the groups of the
/// model. `before_meshing`: what `groups_before_meshing` gave.
std::vector<GroupFigures> group_outcomes(const Revision& parent, const Revision& revision,
                                         std::span<const GroupFigures> before_meshing);

/// Throws Error(POLICY_BROKEN) with the group and its policy for one whose exact area differs from
/// the parent's by more than the policy allows.
void check_areas(const Revision& parent, const FeatureModel& model,
                 std::span<const GroupFigures> figures);

/// Throws Error(POLICY_BROKEN) for a group in `empty` whose policy is to fail when it is empty.
void check_emptied(const FeatureModel& model, std::span<const std::string> empty);

/// The groups of a finished mesh that have neither facets nor tets, in the model's order.
std::vector<std::string> empty_groups(const OutputMesh& output);

}  // namespace remeshd
