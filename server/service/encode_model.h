#pragma once

#include "engine/model/source.h"
#include "remesh/v1/document.pb.h"

namespace remeshd {

/// A model as it was written: parameters in their order, those of features in that of their type's
/// table. `decode` gives it back.
remesh::v1::FeatureModel encode(const ModelSource& source);

}  // namespace remeshd
