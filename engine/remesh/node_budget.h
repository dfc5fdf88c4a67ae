#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/base/run.h"
#include "engine/cellular/cellular_model.h"
#include "engine/model/feature_model.h"
#include "engine/revision/options.h"
#include "engine/sizing/size_rules.h"

namespace remeshd {

/// A size field that was made for a number of nodes.
struct Budgeted {
  SizeField sizes{0};
  double weakening = 1;   ///< of the rules, which ask for edges so many times longer
  double satisfying = 0;  ///< where rules are weakened: number of nodes that would satisfy them
  /// Nodes that a first mesh with the options' seed starts from; null where none had to be made to
  /// be counted.
  std::shared_ptr<const std::vector<Vec3>> start;
};

/// The size field with which a mesh of the model comes out with about `nodes` nodes: the base size
/// is solved for; where the rules alone need more, all of them are weakened by one factor, at most
/// until a circle has 6 edges. Where that still gives more nodes, the mesh has more.
/// Throws Error(MESH_TOO_LARGE) where the rules, not weakened yet, need over four times the limit.
/// @param rules  for base sizes up to `coarsest_base`
Budgeted sizes_for_budget(std::uint32_t nodes, const SizeRules& rules, const MeshOptions& options,
                          const FeatureModel& model, const CellularModel& cells, const Run& run);

/// The greatest base size that is tried for so many nodes: twice the edge length of an even mesh.
double coarsest_base(const CellularModel& cells, double nodes);

}  // namespace remeshd
