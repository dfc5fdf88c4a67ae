#pragma once

#include <string>
#include <vector>

#include "engine/base/run.h"
#include "engine/difference/feature_difference.h"

namespace remeshd {

/// What an element is from one feature's point of view.
struct PointOfView {
  std::string feature;
  DifferenceClass value = DifferenceClass::Artefact;
  friend bool operator==(const PointOfView&, const PointOfView&) = default;
};

struct CombinedCell {
  std::vector<int> owners;  ///< in the model whose positions are used; empty: not in that model
  bool positive = false;    ///< its nature there
  /// All features whose difference covers it, in the history order of the model whose positions
  /// are used.
  std::vector<PointOfView> views;
  double volume = 0;
  /// Combined modified model only: material that some owner can bring along (Sect. 6.2), or
  /// material that none can.
  bool copycell = false, newcell = false;
};

struct CombinedFace {
  std::array<int, 2> cells{-1, -1};
  std::vector<PointOfView> views;
  double area = 0;
};

/// All feature differences put together with the features placed as one of the models has them
/// (Sect. 4.3, Fig. 12). Features that only the other model has are left out.
struct CombinedModel {
  std::vector<CombinedCell> cells;
  std::vector<CombinedFace> faces;
  double copycell_volume = 0, newcell_volume = 0;  ///< combined modified model only
};

/// The combined models with the positions of the modified and of the original model. Both throw
/// what feature_difference throws.
CombinedModel combined_modified_model(const ModelView& original, const ModelView& modified,
                                      const Run& run);
CombinedModel combined_original_model(const ModelView& original, const ModelView& modified,
                                      const Run& run);

}  // namespace remeshd
