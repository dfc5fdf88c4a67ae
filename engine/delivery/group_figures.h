#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/revision/revision.h"

namespace remeshd {

/// A group of facets beside the faces that it stands for.
struct GroupFigures {
  std::string group;                 ///< its faces, joined by `+`; or a name of the model's
  bool of_model = false;             ///< a group of the model
  std::optional<double> exact_area;  ///< of the faces; nothing where the engine does not know it
  double mesh_area = 0;
  Vec3 centroid;  ///< of the facets
  Vec3 normal;    ///< mean of the facets' outward ones, weighted by area; 1 long for a plane
  std::uint32_t nodes = 0, facets = 0, tets = 0;
  std::uint32_t parts = 0;  ///< of the facets: those of different parts have no node in common
  GroupState state = GroupState::Unspecified;
};

/// Of every group of the mesh, counted from the output mesh: in the order of `facet_groups`, then
/// those that were emptied, then those of the model. Takes 0.4 ms for 15,000 nodes.
std::vector<GroupFigures> group_figures(const Revision& revision);

}  // namespace remeshd
