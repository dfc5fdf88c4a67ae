#pragma once

#include "engine/mesh/tet_mesh.h"

namespace remeshd::test {

/// A mesh in arrays of its own, to be changed.
inline TetMesh flat(const PagedMesh& mesh) { return {mesh.nodes.flat(), mesh.tets.flat()}; }

}  // namespace remeshd::test
