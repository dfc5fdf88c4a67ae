#pragma once

#include "remesh/v1/remesh.pb.h"

namespace remeshd::cli {

/// The model that an edit makes of a model, to tell what changes. Pre: the daemon has found the
/// edit valid. What the edit names and the model has not is passed over.
remesh::v1::FeatureModel with_edit(remesh::v1::FeatureModel model,
                                   const remesh::v1::ModelEdit& edit);

}  // namespace remeshd::cli
