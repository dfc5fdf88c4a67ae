#pragma once

#include <vector>

#include "engine/extract/peel.h"
#include "engine/verify/verify.h"

namespace remeshd {

/// The nonconforming facets of a peeled mesh as defects of a verification.
std::vector<MeshDefect> nonconforming_facets(const PeeledMesh& mesh);

/// Whether the boundary of a mesh is complete, whatever is wrong with its tets: a closed manifold
/// with all of the model's vertices, edges and faces.
bool boundary_is_complete(const Verification& verification);

/// Whether `improve` may be asked to clean a mesh up: no tet inverted, the boundary a closed
/// manifold.
bool can_be_improved(const TetMesh& mesh, const Verification& verification);
bool can_be_improved(const PagedMesh& mesh, const Verification& verification);

}  // namespace remeshd
