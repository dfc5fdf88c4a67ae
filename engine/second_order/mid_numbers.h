#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/base/run.h"
#include "engine/revision/output_mesh.h"

namespace remeshd {

/// The edges of a mesh, numbered: an edge of the original whose corner nodes are both still there
/// has the original's mid-node, under its number where there are as many.
struct MidNumbers {
  std::vector<std::array<std::int32_t, 2>> edges;    ///< corner nodes, the lower first
  std::vector<std::array<std::int32_t, 6>> of_tets;  ///< in the order of kTetEdges
  std::vector<std::int32_t> original;                ///< -1 where new
};

/// `output`: with its node map from `original`, which may be a mesh without mid-nodes. Depends on
/// the arguments alone.
MidNumbers number_mids(const OutputMesh& output, const OutputMesh& original, const Run& run);

}  // namespace remeshd
