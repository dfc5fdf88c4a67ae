#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/run.h"
#include "engine/cellular/cellular_model.h"
#include "engine/model/feature_model.h"
#include "engine/remesh/density.h"
#include "engine/revision/options.h"

namespace remeshd {

/// What a mesh of a whole model will take, estimated without making it.
struct Forecast {
  /// A face that asks for short edges, by its first name.
  struct Detail {
    std::string feature, face;
    double size = 0;  ///< length asked for
  };
  std::uint32_t nodes = 0;
  std::uint64_t bytes = 0;      ///< of memory at the peak, beside what the process has
  double seconds = 0;           ///< on one thread of this machine
  std::vector<Detail> details;  ///< sizes below the base size, the least first, at most 20
};

/// Estimates a mesh of this density. Where the size field is even the number of nodes is the one
/// asked for, or follows from volume and area; else the nodes that the mesh would start from are
/// made and counted. Memory and time follow from that by formulas fitted to measured meshes
/// (tests/README.md), time also from how fast this machine makes a small Delaunay mesh.
/// @param density  as resolved for these options
/// @param setup  s that cells and density took
Forecast forecast(const Density& density, const FeatureModel& model, const CellularModel& cells,
                  const MeshOptions& options, double setup, const Run& run);

}  // namespace remeshd
