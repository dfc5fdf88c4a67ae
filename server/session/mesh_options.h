#pragma once

#include "engine/remesh/remesh.h"
#include "server/session/commands.h"

namespace remeshd {

/// Options of a first mesh; throws Error(`OPTIONS_INVALID`).
MeshOptions first_options(const OptionsPatch& patch);

/// Options of an edit of a revision that has `base`; throws Error(`OPTIONS_INVALID`).
MeshOptions edit_options(const OptionsPatch& patch, const MeshOptions& base);

}  // namespace remeshd
