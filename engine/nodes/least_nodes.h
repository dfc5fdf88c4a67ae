#pragma once

#include <string>

#include "engine/model/feature_model.h"

namespace remeshd {

/// A number of nodes that a mesh is certain to need.
struct LeastNodes {
  double nodes = 0;
  std::string feature;  ///< whose material alone needs them; empty where it takes several
};

/// A lower bound of `nodes_needed` for a model, from the features' exact volumes and their boxes
/// alone. It is 0, and takes microseconds, where all features together need no more than `limit`;
/// else it takes at most some 100 ms at 10,000 features. Where features overlap much or are mostly
/// cut away it says little, and the cellular model has to tell.
LeastNodes least_nodes(const FeatureModel& model, double edge_length, double limit);

}  // namespace remeshd
