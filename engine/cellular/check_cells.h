#pragma once

#include "engine/cellular/cell_complex.h"
#include "engine/kernel/brep.h"
#include "engine/model/solid.h"

namespace remeshd {

/// Checks the CAD kernel's cells against the features' closed formulas, because the kernel can fail
/// silently: owners at points inside each cell, and the volume of each feature. Sets Cell::inside.
///
/// Throws Error(KERNEL_FAILURE) with the features and a place.
void check_cells(CellComplex& cells, const kernel::Brep& brep, const FeatureModel& model,
                 const Membership& membership);

}  // namespace remeshd
