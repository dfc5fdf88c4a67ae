#pragma once

#include <string>
#include <vector>

#include "engine/model/solid.h"
#include "engine/verify/verify.h"

namespace remeshd {

/// What lies at the place of a mesh's defect, in the user's words.
struct FailurePlace {
  std::vector<std::string> faces;     ///< `hole1.wall`; none where the whole mesh is wrong
  std::vector<std::string> features;  ///< their ids, each once
};

/// Names the model faces at a defect: those at the model edge or vertex that is missing, or the
/// face that is not covered; for other defects the nearest face, and the next one if it is within
/// `reach`.
FailurePlace find_failure(const MeshDefect& defect, const FeatureModel& model,
                          const Membership& membership, const BoundaryModel& boundary,
                          double reach);

/// One clause: the defect, its place, and the faces there: `..., between plate.top and hole1.wall`.
std::string describe(const MeshDefect& defect, const FailurePlace& place);

}  // namespace remeshd
