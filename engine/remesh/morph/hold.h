#pragma once

#include "engine/remesh/morph/morph.h"

namespace remeshd {

/// Keeps the connectivity of `original` as `MeshOptions::hold` of `modified` asks: while no surface
/// is further than that many edge lengths from where it was when the connectivity was made (the
/// anchor), with the same features and topology. Every node is placed anew from where it was then
/// (`held_places`), so that the mesh depends on the anchor and the model alone, smoothly, and any
/// number of steps ends where one step would. The one exception: a mid-node whose edge had to be
/// straightened on the way stays in the middle.
///
/// Returns why the connectivity is not held where it is not.
/// Post: the mesh is valid; each tet has dihedral angles from 10 to 165 degrees and a volume-length
/// of at least 0.25, or is as good as it was at the anchor.
std::variant<MorphedMesh, NotMorphed> hold_mesh(const Revision& original, const Revision& modified,
                                                const Run& run);

}  // namespace remeshd
