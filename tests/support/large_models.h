#pragma once

#include "engine/model/source.h"

namespace remeshd::test {

// Models of as many features as asked for, for what should cost what changed.

/// One block with holes and pins by turns in a square grid; features `f1`, `f2` ...
ModelSource plate_with_grid(int features);

/// Blocks `f0`, `f1` ... in a row that overlap their neighbours, each a little lower than the last
/// or a little higher, by turns.
ModelSource row_of_blocks(int features);

/// Plates side by side that overlap, each with bosses, holes through the bosses and slots.
ModelSource mixed_model(int features);

/// The model with feature `id` moved by (x, y, z).
ModelSource with_moved(ModelSource model, const std::string& id, double x, double y, double z);

/// The model with a feature's parameter changed.
ModelSource with_parameter(ModelSource model, const std::string& id, const std::string& name,
                           double value);

}  // namespace remeshd::test
