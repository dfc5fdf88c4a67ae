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

/// What meshing a whole model comes to, told without meshing it.
struct Forecast {
  /// What asks for short edges: a face, by the feature that it is named after first.
  struct Detail {
    std::string feature, face;
    double size = 0;  ///< length asked for
  };
  std::uint32_t nodes = 0;
  std::uint64_t bytes = 0;      ///< of memory at the peak, beside what the process has
  double seconds = 0;           ///< on one thread of this machine
  std::vector<Detail> details;  ///< that ask for less than the base size; the least first, some
};

/// Nodes are those of a start of the mesh, which is made and counted where the field is not even;
/// memory and time follow from them by what meshes have taken (tests/README.md), time by the speed
/// of this machine in a small Delaunay mesh.
/// @param density  as resolved for these options
/// @param setup  s that cells and density took
Forecast forecast(const Density& density, const FeatureModel& model, const CellularModel& cells,
                  const MeshOptions& options, double setup, const Run& run);

}  // namespace remeshd
