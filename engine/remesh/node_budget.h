#pragma once

#include <cstdint>

#include "engine/base/run.h"
#include "engine/cellular/cellular_model.h"
#include "engine/model/feature_model.h"
#include "engine/revision/options.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

/// The size field whose base size makes a mesh of the model start with about `nodes` nodes, as the
/// options' rules are. `first`: one with a guess at the base size.
SizeField sizes_for_budget(std::uint32_t nodes, const SizeField& first, const MeshOptions& options,
                           const FeatureModel& model, const CellularModel& cells, const Run& run);

}  // namespace remeshd
