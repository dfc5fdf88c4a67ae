// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "remeshd/mesh.h"

namespace remeshd::client {

/// One name and the groups that carry it, ascending.
struct NamedGroups {
  std::string name;
  std::vector<std::int32_t> groups;
};

/// Turns "groups and their names" round: every name once, in the order of first appearance, with
/// all its groups.
std::vector<NamedGroups> by_name(const std::vector<std::vector<std::string>>& groups);

/// A group of the model with what the mesh has of it, ascending.
struct ModelGroup {
  std::string name;
  std::vector<std::int32_t> facets, tets;
};

/// The groups of the model, in its order.
std::vector<ModelGroup> model_groups(const Mesh& mesh);

/// Name of the set of all tets, and of all nodes, where no group of the model has it.
inline constexpr const char* kAllName = "remesh_all";

/// Where a mesh comes from, a line each: `revision 1a2b...`, `model bracket`, `unit mm`,
/// `options {...}`, `remeshd algorithm 20`. What is not known is left out; control characters are
/// blanks.
std::vector<std::string> provenance(const Mesh& mesh);

}  // namespace remeshd::client
