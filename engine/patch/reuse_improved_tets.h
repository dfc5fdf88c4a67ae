#pragma once

#include <functional>
#include <span>
#include <vector>

#include "engine/extract/peel.h"
#include "engine/nodes/node_set.h"
#include "engine/patch/patch.h"

namespace remeshd {

/// By tet of a mesh: the tets with the same nodes in two other meshes, -1 where none is known. Both
/// lists are empty where nothing is known.
struct SameTets {
  std::vector<std::int32_t> peeled;  ///< of the new peeled Delaunay mesh
  std::vector<std::int32_t> output;  ///< of MeshPatch::output
};

/// A peeled Delaunay mesh in which everything that did not change has already been replaced by the
/// original's cleaned-up mesh, to the bit and with its connectivity.
struct ReusedMesh {
  TetMesh mesh;  ///< node i is node i of the NodeSet
  std::vector<std::uint8_t>
      dirty;  ///< per tet: 1 where it is not the original's and may need clean-up
  SameTets same;
};

/// Reuses the parent's improved tets wherever the new Delaunay mesh has the same Delaunay tets.
///
/// Clean-up replaces cavities of Delaunay tets by cavities of others with the same hull. A cavity
/// whose Delaunay tets are all in the new mesh, copied with one transformation, is replaced again;
/// a Delaunay tet that clean-up left alone stands for itself. Nodes of reused tets take their
/// output position; where that would spoil a tet next to them, the tets round them are not
/// reused.
///
/// Where nodes moved by next to nothing, as by a morph, the new mesh may have other tets of the
/// same nodes than the original, with the same hull: the original's are taken for them, and
/// cavities are found all the same.
///
/// `peeled`: the new peeled Delaunay mesh over `nodes`, made out of that of `original`: a tet that
/// was left alone stands in the same slot. `transforms`: as in CopyPlan. `unchanged`: whether the
/// models are the same round a tet of `nodes`, so that it may be exchanged for others; may be null:
/// none is. Interface nodes keep their output position; throws PatchTooSmall where one of them
/// would have to move.
ReusedMesh reuse_improved_tets(const NodeSet& nodes, const PeeledMesh& peeled,
                               const MeshPatch& original, std::span<const Transform> transforms,
                               const std::function<bool(const Tet&)>& unchanged, const Run& run);

}  // namespace remeshd
