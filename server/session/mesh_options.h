#pragma once

#include "engine/remesh/remesh.h"
#include "server/session/commands.h"

namespace remeshd {

/// Options of a first mesh of a model. Rules of a size field and sizes of the model mean that it is
/// not even, where the patch does not say that it is. Throws Error(`OPTIONS_INVALID`).
MeshOptions first_options(const OptionsPatch& patch, const ModelSource& model);

/// Likewise of an edit of a revision that has `base` and `model`, which it makes `edited`: so do
/// sizes that the edit changes.
MeshOptions edit_options(const OptionsPatch& patch, const MeshOptions& base,
                         const ModelSource& model, const ModelSource& edited);

}  // namespace remeshd
