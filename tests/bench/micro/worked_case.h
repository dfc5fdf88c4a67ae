#pragma once

#include <memory>
#include <vector>

#include "engine/boundary/samples.h"
#include "engine/cellular/cellular_model.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/model/solid.h"
#include "engine/nodes/node_set.h"

namespace remeshd::bench {

/// tool1-a with 15,000 nodes, ready for each stage of a regular run to be tried alone.
struct WorkedCase {
  FeatureModel model;
  CellularModel cells;
  std::unique_ptr<const Membership> membership;
  double edge_length = 0;
  Samples samples;
  std::vector<std::uint32_t> all_samples;  ///< their indices
  NodeSet nodes;                           ///< after five iterations, all free
  std::vector<Tet> delaunay;               ///< of these
  NodeSet mesh_nodes;                      ///< those of the peeled mesh
  std::vector<Tet> peeled;                 ///< before clean-up
};

/// Made once.
const WorkedCase& worked_case();

}  // namespace remeshd::bench
