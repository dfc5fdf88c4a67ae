#pragma once

#include <string>
#include <vector>

#include "engine/base/run.h"
#include "engine/cellular/cellular_model.h"
#include "engine/model/feature_model.h"

namespace remeshd {

/// What a STEP file tells beside the geometry.
struct ModelLabels {
  std::string name;                      ///< of the model, and of the solid
  std::string unit;                      ///< as the document has it
  std::string file;                      ///< the name that the header has
  std::vector<std::string> description;  ///< lines
  std::string origin;                    ///< the program that made it
};

/// The boundary of a model as an exact B-rep in a STEP file: one solid, named after the model, each
/// face after the features' faces that cover it, as `base.top+boss.bottom`. Rims of groups are
/// edges, as they are in BoundaryModel. Coordinates are the model's; the unit is the label's where
/// that is one of mm, cm, m, um, in, inch, ft, else millimetres.
///
/// It is made by a general fuse of its own, so that the same model gives the same bytes however its
/// cells came about, and read back: volume and area are those of `cells` to 1e-6.
///
/// Pre: the cells are the model's.
/// Throws Error(KERNEL_FAILURE), Error(Cancelled).
std::string model_step(const FeatureModel& model, const CellularModel& cells,
                       const ModelLabels& labels, const Run& run);

}  // namespace remeshd
