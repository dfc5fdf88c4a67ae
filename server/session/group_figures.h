#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/remesh/remesh.h"

namespace remeshd {

/// A group of facets beside the faces that it stands for.
struct GroupFigures {
  std::string group;                 ///< its faces, joined by `+`
  std::optional<double> exact_area;  ///< of the faces; nothing where the engine does not know it
  double mesh_area = 0;
  Vec3 centroid;  ///< of the facets
  Vec3 normal;    ///< mean of the facets' outward ones, weighted by area; 1 long for a plane
  std::uint32_t nodes = 0, facets = 0;
};

/// Of every group of the mesh, in the order of `facet_groups`, counted from the output mesh.
/// Takes 0.4 ms for 15,000 nodes.
std::vector<GroupFigures> group_figures(const Revision& revision);

}  // namespace remeshd
