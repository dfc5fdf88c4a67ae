#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/boundary/entity_map.h"
#include "engine/delaunay/paged_delaunay.h"
#include "engine/nodes/node_set.h"
#include "engine/nodes/surroundings.h"
#include "engine/patch/cavities.h"
#include "engine/patch/copied_mesh.h"
#include "engine/plan/copy_plan.h"

namespace remeshd {

/// The patch of an original mesh that an edit works on, with numbers of its own. All of an inner
/// node's tets are in it; interface nodes have others too.
///
/// Its tets are whole cavities: the peeled Delaunay tets and the output tets have the same hull.
struct MeshPatch {
  std::vector<std::int32_t> nodes;     ///< by node: that of the original, ascending
  std::vector<std::uint8_t> inner;     ///< by node
  std::vector<Vec3> positions;         ///< by node: `CopiedMesh::positions`
  std::vector<Vec3> output_nodes;      ///< by node: its position in `CopiedMesh::output`
  std::vector<std::uint8_t> followed;  ///< by node: 1 if among `CopiedMesh::followed`
  DelaunayMesh mesh;
  PagedDelaunay::Cut cut;
  std::vector<Tet> tets;                      ///< those of `mesh` that are in the model
  Cavities cavities;                          ///< of `tets` and `output`
  std::vector<Tet> output;                    ///< output tets in the place of `tets`
  std::vector<std::int32_t> output_tet;       ///< by output tet: that of the original
  std::vector<std::int32_t> parent_cavities;  ///< by cavity: its number in the Delaunay state
  std::vector<std::uint8_t> inside;           ///< by slot of `mesh`: 1 if among `tets`
  std::vector<std::uint8_t> exterior;         ///< by element of `cut.exterior`: 1 if in the model
};

/// Cuts out the tets at inner nodes and all tets of cavities with such a tet. Outside of the model
/// it also cuts out the tets whose circumballs may be entered by nodes that move or are added.
/// `inner`: by node of the original, 1 for inner ones. `changing`: where nodes may move or be
/// added; null: only at inner nodes.
MeshPatch cut_patch(const CopiedMesh& original, const std::vector<std::uint8_t>& inner,
                    const Surroundings* changing);

/// The nodes that an edit works on, and the patch of the original that they came from.
struct PatchNodes {
  NodeSet nodes;
  MeshPatch patch;          ///< empty for a first mesh
  std::int32_t placed = 0;  ///< nodes with smaller numbers have supports in the modified boundary
};

/// Cuts out of the original the patch within `reach` (length) of what changes, or has followed
/// surfaces; all of the original where `reach` is infinite. `near`: the nodes that the plan made of
/// `candidates`, nodes of the original, and the new nodes.
///
/// The patch's other nodes, and those at its interface, come first, with supports translated by
/// `map`. Nodes of `near` follow with the supports that they have there, in the original's
/// boundary. Returns nothing where `map` has no support for a node.
std::optional<PatchNodes> extract_patch(const CopiedNodes& near,
                                        std::span<const std::int32_t> candidates,
                                        const CopiedMesh& original, const EntityMap* map,
                                        const CopyPlan& plan, double reach);

}  // namespace remeshd
