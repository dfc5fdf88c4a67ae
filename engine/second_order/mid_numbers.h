#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/base/run.h"
#include "engine/revision/output_mesh.h"

namespace remeshd {

/// The numbers of the edges of a mesh, each with its mid-node.
struct MidNumbers {
  std::vector<std::array<std::int32_t, 2>> edges;    ///< by mid-node: corner nodes, the lower first
  std::vector<std::array<std::int32_t, 6>> of_tets;  ///< by tet, in the order of kTetEdges
  std::vector<std::int32_t> original;  ///< by mid-node: that of the original; -1 where new
};

/// Numbers the edges of `output`. An edge of the original whose corner nodes are both still there
/// keeps its mid-node, and its number unless that exceeds the number of edges now. `output`: with
/// its node map from `original`, which may be a mesh without mid-nodes. Depends on the arguments
/// alone.
MidNumbers number_mids(const OutputMesh& output, const OutputMesh& original, const Run& run);

}  // namespace remeshd
