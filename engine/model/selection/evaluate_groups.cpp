#include "engine/model/selection/evaluate_groups.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "engine/base/error.h"
#include "engine/model/expression.h"
#include "engine/model/limits.h"
#include "engine/model/selection/select_faces.h"
#include "engine/model/selection/selection_error.h"

namespace remeshd {
namespace {

void check_policy(const GroupPolicy& policy, const std::string& where) {
  if (policy.max_area_change &&
      !(*policy.max_area_change >= 0 && std::isfinite(*policy.max_area_change)))
    throw error::value_out_of_range("", where + ".policy.maxAreaChange", *policy.max_area_change,
                                    "0 at least");
}

}  // namespace

std::vector<FaceGroup> evaluate_groups(const ModelSource& source,
                                       const std::vector<Feature>& features, const Scope& scope,
                                       SelectorCost& cost) {
  if (source.groups.size() > kMaxSelections)
    throw error::limit_exceeded("", "groups", "groups", source.groups.size(), kMaxSelections);
  std::set<std::string_view> names;
  std::vector<FaceGroup> groups;
  for (const GroupSource& group : source.groups) {
    const std::string where = "groups." + group.name;
    check_name(group.name, "", where + ".name");
    if (!names.insert(group.name).second) throw error::duplicate_group(group.name);
    if (std::ranges::find(features, group.name, &Feature::id) != features.end())
      throw error::group_named_as_feature(group.name);
    check_policy(group.policy, where);
    groups.push_back({group.name,
                      select_faces(group.on, source, features, scope, where + ".on", cost),
                      group.policy});
  }
  return groups;
}

}  // namespace remeshd
