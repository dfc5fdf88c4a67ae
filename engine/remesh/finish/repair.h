#pragma once

#include <span>
#include <vector>

#include "engine/boundary/samples.h"
#include "engine/delaunay/delaunay_mesh.h"
#include "engine/extract/peel.h"
#include "engine/nodes/node_set.h"
#include "engine/sizing/size_field.h"
#include "engine/verify/verify.h"

namespace remeshd {

/// Inserts boundary nodes where a mesh failed to represent the boundary. A link of a model edge
/// that is no boundary edge is halved; near the other defects a node goes to the sample that is
/// farthest from any. That is where the boundary is too thinly occupied for its facets to be
/// Delaunay.
///
/// Returns the number of nodes inserted; 0 where everything near the defects has its node.
int insert_where_missing(NodeSet& nodes, std::span<const MeshDefect> defects,
                         const BoundaryModel& boundary, const Samples& samples,
                         const SizeField& sizes);

/// The nonconforming facets of a peeled mesh as verification would name them.
std::vector<MeshDefect> nonconforming_facets(const PeeledMesh& mesh);

/// Whether all that is wrong with a mesh is its tets: its surface is closed and has the model's
/// vertices, edges and faces.
bool boundary_is_complete(const Verification& verification);

/// Whether `improve` may be asked to clean a mesh up: no tet inverted, the boundary a closed
/// manifold.
bool can_be_improved(const TetMesh& mesh, const Verification& verification);
bool can_be_improved(const PagedMesh& mesh, const Verification& verification);

/// Brings a Delaunay mesh of the first nodes up to all of them, with their model edges recovered.
DelaunayMesh with_nodes_inserted(const DelaunayMesh& mesh, std::int32_t first_inserted,
                                 NodeSet& nodes, const BoundaryModel& boundary,
                                 const SizeField& sizes, const Run& run);

}  // namespace remeshd
