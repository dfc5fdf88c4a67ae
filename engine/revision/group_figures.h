#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/revision/revision.h"

namespace remeshd {

/// A group of facets where one word is wanted: its faces joined by `+`.
inline std::string group_name(const std::vector<std::string>& faces) {
  std::string name;
  for (const std::string& face : faces) name += (name.empty() ? "" : "+") + face;
  return name;
}

/// Of every group of the mesh, counted from the output mesh: in the order of `facet_groups`, then
/// those of the model, whose exact areas are in `of_model`. States are left open.
std::vector<GroupFigures> group_figures(const Revision& revision,
                                        std::span<const GroupFigures> of_model = {});

}  // namespace remeshd
