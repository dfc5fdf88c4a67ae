#pragma once

#include "engine/remesh/remesh.h"
#include "server/session/commands.h"

namespace remeshd {

/// Options of a first mesh: what the patch leaves out has the defaults of requests, which are not
/// the engine's: 15,000 nodes, sized by all rules. Throws Error(`OPTIONS_INVALID`).
MeshOptions first_options(const OptionsPatch& patch);

/// Options of an edit of a revision with the options `base`. A patch with rules of a size field
/// makes the mesh not even, unless it says that it is. Throws Error(`OPTIONS_INVALID`).
MeshOptions edit_options(const OptionsPatch& patch, const MeshOptions& base);

}  // namespace remeshd
