#pragma once

#include <vector>

#include "engine/kernel/tetgen.h"

namespace remeshd {

/// The tets of a filled surface that lie in material. TetGen fills voids too, for it does not know
/// one side of the surface from the other; here its triangles' orientation, outward, tells.
std::vector<Tet> tets_in_material(const kernel::TetGenMesh& filling,
                                  const kernel::TetGenSurface& surface);

}  // namespace remeshd
