// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace remeshd::client {

/// One name and the groups that carry it, ascending.
struct NamedGroups {
  std::string name;
  std::vector<std::int32_t> groups;
};

/// Turns "groups and their names" round: every name once, in the order of first appearance, with
/// all its groups.
std::vector<NamedGroups> by_name(const std::vector<std::vector<std::string>>& groups);

}  // namespace remeshd::client
