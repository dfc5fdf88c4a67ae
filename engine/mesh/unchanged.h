#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/tet_boxes.h"

namespace remeshd {

/// What of a mesh is another's, to the bit and under the same numbers.
struct Unchanged {
  std::vector<std::uint8_t> node;  ///< by node: 1 where the other has it there
  /// By page of tets: 1 where all tets are the other's, between nodes that it has there.
  std::vector<std::uint8_t> page;
  std::vector<std::int32_t> changed_tets;  ///< those that are not, ascending
};

/// Memory that the two share tells what is the same: a page of tets is looked through only where
/// nodes that moved may be its own. `boxes`: round the other's tets.
Unchanged unchanged(const PagedMesh& mesh, const PagedMesh& other, const CowVector<Box>& boxes);

}  // namespace remeshd
