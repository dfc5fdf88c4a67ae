#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/run.h"
#include "engine/verify/inheritance.h"

namespace remeshd {

struct FacetMatch {
  std::vector<SurfaceFacet> surface;  ///< in the order of their tets
  std::vector<std::int32_t>
      clashes;  ///< tets that share a facet with another on the same side of it, or with two others
};

/// Matches the facets of all tets.
FacetMatch match_facets(const CowVector<Tet>& tets, std::size_t node_count, Polling& poll);

/// The same, but only facets whose nodes are all touched are matched; of all others the parent
/// tells which are on the surface.
FacetMatch match_facets(const CowVector<Tet>& tets, std::size_t node_count,
                        const VerifiedParent& parent, const TetCorrespondence& inherited,
                        Polling& poll);

/// Tets with the same four nodes as an earlier one. `clashes`: FacetMatch::clashes of these tets.
std::vector<std::int32_t> repeated_tets(const CowVector<Tet>& tets, std::size_t node_count,
                                        std::span<const std::int32_t> clashes);

}  // namespace remeshd
