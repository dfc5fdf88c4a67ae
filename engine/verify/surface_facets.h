#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/run.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

/// A facet that is in one tet only.
struct SurfaceFacet {
  Triangle nodes;  ///< outward
  std::int32_t tet;
};

struct FacetMatch {
  std::vector<SurfaceFacet> surface;  ///< in the order of their tets
  std::vector<std::int32_t>
      clashes;  ///< tets with a facet that others share on the same side of it
};

/// Matches the facets of all tets.
FacetMatch match_facets(std::span<const Tet> tets, std::size_t node_count, Polling& poll);

}  // namespace remeshd
