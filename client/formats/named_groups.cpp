// SPDX-License-Identifier: Apache-2.0
#include "client/formats/named_groups.h"

#include <map>

namespace remeshd::client {

std::vector<NamedGroups> by_name(const std::vector<std::vector<std::string>>& groups) {
  std::vector<NamedGroups> names;
  std::map<std::string, std::size_t> place;
  for (std::size_t group = 0; group < groups.size(); ++group) {
    for (const std::string& name : groups[group]) {
      const auto [entry, added] = place.emplace(name, names.size());
      if (added) names.push_back({name, {}});
      auto& carried = names[entry->second].groups;
      const auto index = static_cast<std::int32_t>(group);
      if (carried.empty() || carried.back() != index) carried.push_back(index);
    }
  }
  return names;
}

}  // namespace remeshd::client
