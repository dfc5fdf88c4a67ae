#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/tet_boxes.h"

namespace remeshd {

/// What a mesh has in common with another one, under the same numbers.
struct Unchanged {
  std::vector<std::uint8_t> node;  ///< by node: 1 where the other has it at the same place
  /// By page of tets: 1 where the other has the same tets on it, with all of their nodes in place.
  std::vector<std::uint8_t> page;
  /// Tets that the other does not have, or with a node that it has elsewhere; ascending.
  std::vector<std::int32_t> changed_tets;
};

/// Compares a mesh with another one. Pages whose memory both share are known to be the same: such a
/// page of tets is searched only where it may use nodes that moved. `boxes`: round the other mesh's
/// pages of tets.
Unchanged unchanged(const PagedMesh& mesh, const PagedMesh& other, const CowVector<Box>& boxes);

}  // namespace remeshd
