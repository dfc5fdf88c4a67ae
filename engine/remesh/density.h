#pragma once

#include <cstdint>
#include <optional>

#include "engine/base/run.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// Target edge length and density of new nodes, as the options ask for and the original gives.
struct Density {
  double edge_length = 0;              ///< l: spacing of samples, reach of searches
  double nodes_per_volume = 0;         ///< in newcells
  std::optional<std::uint32_t> count;  ///< of a first mesh asked for by number of nodes
  bool inherited = false;              ///< an edit keeps its base's density
};

/// Throws Error(InvalidArgument): `OPTIONS_INVALID`; `MESH_TOO_LARGE` where a mesh of this density
/// would need more nodes than `run.max_nodes`.
Density resolve_density(const Revision& parent, const MeshOptions& options,
                        const CellularModel& cells, const Run& run);

}  // namespace remeshd
