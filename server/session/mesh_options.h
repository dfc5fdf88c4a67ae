#pragma once

#include "engine/remesh/remesh.h"
#include "server/session/commands.h"

namespace remeshd {

/// Options of a first mesh. Rules of a size field mean that it is not even, where the patch does
/// not say that it is. Throws Error(`OPTIONS_INVALID`).
MeshOptions first_options(const OptionsPatch& patch);

/// Likewise of an edit of a revision that has `base`. Throws Error(`OPTIONS_INVALID`).
MeshOptions edit_options(const OptionsPatch& patch, const MeshOptions& base);

}  // namespace remeshd
