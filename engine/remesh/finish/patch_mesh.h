#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/delaunay/delaunay_mesh.h"
#include "engine/nodes/node_set.h"
#include "engine/patch/candidate.h"
#include "engine/patch/patch.h"
#include "engine/patch/reuse_improved_tets.h"
#include "engine/remesh/steps.h"

/// The steps from a patch's optimised nodes to its mesh, put back into the parent's.
namespace remeshd {

/// The peeled Delaunay mesh of optimised nodes; nodes in no tet are left out. Throws PatchTooSmall.
Candidate extract(NodeSet nodes, OptimiseResult loop, const MeshingTask& task,
                  const MeshPatch& patch, const InsideTest& inside);

/// The Delaunay mesh's tets in the model.
PeeledMesh peeled(const Candidate& c, const MeshingTask& task, const MeshPatch& patch,
                  const InsideTest& inside);

struct DroppedNodes {
  std::vector<std::int32_t> number;  ///< by node: the number it has now; -1: it was left out
  /// Whether the Delaunay mesh had to be built anew: its tets are in other slots, and where nodes
  /// share an empty sphere they may be others.
  bool rebuilt = false;
};

/// Leaves out the nodes that no tet uses, but for those at the interface, and renumbers the tets
/// and the Delaunay mesh. Throws PatchTooSmall.
DroppedNodes drop_unused(NodeSet& nodes, std::vector<Tet>& tets, DelaunayMesh& mesh,
                         const Run& run);

/// The patch's mesh: improved tets reused where nothing changed, the rest cleaned up if `clean_up`.
/// Sets `c.bad_at_interface`. Throws PatchTooSmall.
ReusedMesh cleaned_up(Candidate& c, const MeshingTask& task, const MeshPatch& patch, bool clean_up);

/// Puts a patch's mesh into the parent's and verifies the whole; `most_failures` as in
/// VerifyOptions. Throws PatchTooSmall.
void put_back(Candidate& c, const ReusedMesh& mesh, const MeshingTask& task, const MeshPatch& patch,
              std::uint32_t most_failures = VerifyOptions{}.most_failures);

/// `values[at[k]]` for each k; -1 where `at[k]` is negative, or where there are no values at all.
std::vector<std::int32_t> looked_up(std::span<const std::int32_t> values,
                                    std::span<const std::int32_t> at);

}  // namespace remeshd
