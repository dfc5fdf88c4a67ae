// SPDX-License-Identifier: Apache-2.0
#include "client/formats/named_groups.h"

#include <algorithm>
#include <map>

namespace remeshd::client {
namespace {

/// With blanks for control characters: a line break would end the comment that a value stands in,
/// and XML takes no others.
std::string on_one_line(std::string value) {
  constexpr unsigned char kBlank = 0x20, kDelete = 0x7f;
  std::ranges::replace_if(
      value, [](unsigned char c) { return c < kBlank || c == kDelete; }, ' ');
  return value;
}

}  // namespace

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

std::vector<ModelGroup> model_groups(const Mesh& mesh) {
  std::vector<ModelGroup> groups;
  for (const std::string& name : mesh.group_names) groups.push_back({name, {}, {}});
  for (const auto& [group, facet] : mesh.group_facets)
    groups[static_cast<std::size_t>(group)].facets.push_back(facet);
  for (const auto& [group, tet] : mesh.group_tets)
    groups[static_cast<std::size_t>(group)].tets.push_back(tet);
  return groups;
}

std::vector<std::string> provenance(const Mesh& mesh) {
  std::vector<std::string> lines;
  const auto add = [&](const char* what, const std::string& value) {
    if (!value.empty()) lines.push_back(std::string(what) + " " + on_one_line(value));
  };
  add("revision", mesh.revision);
  add("parent", mesh.parent);
  add("model", mesh.model_name);
  add("unit", mesh.unit);
  add("options", mesh.options);
  if (mesh.algorithm_version > 0) add("remeshd algorithm", std::to_string(mesh.algorithm_version));
  return lines;
}

}  // namespace remeshd::client
