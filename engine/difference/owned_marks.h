#pragma once

#include <vector>

#include "engine/cellular/cellular_model.h"
#include "engine/difference/classification.h"

namespace remeshd {

/// What some features own in one cellular model: their cells and all that bounds those.
///
/// Each list has an entry for every element of `CellComplex::brep`: the element's mark in its
/// model, Absent where not owned, or where it is a seam and so no element.
struct OwnedMarks {
  std::vector<Mark> cells, faces, edges, vertices;

  [[nodiscard]] std::vector<int> owned_cells() const;
};

OwnedMarks owned_marks(const CellComplex& model, const std::vector<int>& features);

}  // namespace remeshd
