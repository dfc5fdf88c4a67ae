#pragma once

#include "engine/model/feature_model.h"
#include "engine/model/solid.h"

namespace remeshd::campaign {

/// How many pairs of features touch in a way that CAD kernels and meshers find hard, by their
/// surfaces' numbers, whatever the model was made for.
struct Contacts {
  int tangent = 0;     ///< surfaces that touch at a point or along a line without crossing there
  int coincident = 0;  ///< faces that share an area
  int film = 0;        ///< faces that nearly do, a millionth of the diagonal or less apart
};

/// Looks at all pairs. Tangent pairs of planes, cylinders and spheres, and of coaxial round
/// surfaces; the contact must lie on the faces of both features.
Contacts find_contacts(const FeatureModel& model, const Membership& membership);

}  // namespace remeshd::campaign
