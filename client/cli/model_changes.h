#pragma once

#include <string>
#include <vector>

#include "remesh/v1/remesh.pb.h"

namespace remeshd::cli {

/// What differs between two models, in words: `wall 7 -> 8`, `hole.radius 8 -> 9`, `hole moved`,
/// `+ rib`, `- rib`. Parameters first, then features, sizes and groups, each as they stand in
/// `after`, then those that have gone. None for models that are the same.
std::vector<std::string> model_changes(const remesh::v1::FeatureModel& before,
                                       const remesh::v1::FeatureModel& after);

/// The same in one line; `same model` where there are none.
std::string changes_in_words(const remesh::v1::FeatureModel& before,
                             const remesh::v1::FeatureModel& after);

}  // namespace remeshd::cli
