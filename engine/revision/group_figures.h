#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/revision/revision.h"

namespace remeshd {

/// The name of a group of facets in one word: its faces joined by `+`.
inline std::string group_name(const std::vector<std::string>& faces) {
  std::string name;
  for (const std::string& face : faces) name += (name.empty() ? "" : "+") + face;
  return name;
}

/// Figures of every group, measured on the output mesh: of the groups of facets in the order of
/// `facet_groups`, then of the model's groups, whose exact areas are taken from `of_model` by name.
/// `state` is left Unspecified.
std::vector<GroupFigures> group_figures(const Revision& revision,
                                        std::span<const GroupFigures> of_model = {});

}  // namespace remeshd
