#pragma once

#include "engine/remesh/remesh.h"
#include "server/session/commands.h"

namespace remeshd {

/// Options of a first mesh: what the patch leaves out has the defaults of requests, which the
/// engine's own are not: 15,000 nodes, sized by all rules. Throws Error(`OPTIONS_INVALID`).
MeshOptions first_options(const OptionsPatch& patch);

/// Options of an edit of a revision that has `base`. Rules of a size field mean that the mesh is
/// not even, where the patch does not say that it is. Throws Error(`OPTIONS_INVALID`).
MeshOptions edit_options(const OptionsPatch& patch, const MeshOptions& base);

}  // namespace remeshd
