#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/base/random.h"
#include "engine/model/feature_model.h"

namespace remeshd::campaign {

/// What an optimisation loop or an engineer does to a part.
enum class Change { Drift, Sweep, Jump, Move, Addition, Removal };
inline constexpr std::array<const char*, 6> kChangeNames{"drift", "sweep",    "jump",
                                                         "move",  "addition", "removal"};

/// Edits that belong together, each to be made after the one before.
struct ChangeSteps {
  std::vector<ModelEdit> edits;
  std::vector<double> sizes;  ///< of what each changes, by the model's diagonal
};

/// Several small steps of one or two parameters, a parameter from where it is to another value, or
/// one edit. A parameter is one of the model, one of a feature and of those made to the same
/// pattern, an extent of an outline, or a place. What is moved, added or removed takes smaller
/// features on the same axis along, as a boss its drill; what is added is like something there.
///
/// Whether the models are good ones nobody has looked at.
/// Throws Error where there is nothing to be changed so.
ChangeSteps random_change(const ModelSource& part, Change change, Random& random, int& serial);

/// For each feature, those of its pattern, itself among them: the same type, nature and
/// measurements, and names that are alike up to their first digit.
std::vector<std::vector<int>> patterns(const ModelSource& part);

/// A feature and the smaller ones on its axis that touch it, in history order.
std::vector<int> with_what_it_carries(const FeatureModel& model, int feature);

}  // namespace remeshd::campaign
