#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/run.h"
#include "engine/boundary/samples.h"
#include "engine/delaunay/delaunay_mesh.h"
#include "engine/nodes/node_set.h"
#include "engine/sizing/size_field.h"
#include "engine/verify/verify.h"

/// Inserts nodes until a Delaunay mesh has the model's boundary: in missing segments of model
/// edges, then beside missing facets.
namespace remeshd {

struct SegmentOptions {
  SizeField sizes{0};  ///< target edge lengths
  int rounds = 12;     ///< at most
  /// Insertion ends after the round that brings it to more than this share of the nodes at the
  /// beginning, plus 200: two model edges much nearer to each other than the edge length would
  /// split each other into pieces as short as their distance.
  double most = 0.2;
  /// For a patch of a mesh: the model edges that must have nodes in it, ascending. Any other model
  /// edge without nodes in the patch may have its nodes outside of it.
  std::vector<std::int32_t> wanted;
  /// By model edge: links that it has to have at least; empty: any number does.
  std::vector<int> fewest_links;
  bool make_room = false;  ///< whether what is in the way of a link moves or gets a node opposite
};

/// Makes model edges present that are missing: a model edge has to be a chain of mesh edges between
/// its nodes (Sect. 3.4), and where one link is not in the Delaunay mesh, a node is inserted into
/// it; where there are too few links, the longest are halved. Near a model vertex the insertion
/// keeps to shells of radius l / 2^k round it, so that edges meeting at a sharp angle do not split
/// each other for ever (Ruppert 1995).
///
/// `mesh`: of the first `in_mesh` nodes. Post: it is of all nodes; links are still missing where
/// `rounds` or `most` did not suffice. Returns the number of nodes inserted or moved. Throws
/// PatchTooSmall.
int insert_in_segments(NodeSet& nodes, DelaunayMesh& mesh, std::int32_t in_mesh,
                       const BoundaryModel& boundary, const SegmentOptions& options,
                       const Run& run);

/// Inserts boundary nodes where a mesh failed to represent the boundary. A model vertex without a
/// node gets the nearest one, if that may move there, else a new one; a link of a model edge that
/// is no boundary edge is halved; near the other defects, or where the link has no room, a
/// node goes to the sample that is farthest from any node. That is where the boundary has too few
/// nodes for its facets to be Delaunay. `make_room`: what is in the way of a link without room
/// moves or gets a node opposite (`CrowdedLinks`).
///
/// Returns the number of nodes inserted and moved; 0 where everything near the defects has its
/// node.
int insert_where_missing(NodeSet& nodes, std::span<const MeshDefect> defects,
                         const BoundaryModel& boundary, const Samples& samples,
                         const SizeField& sizes, bool make_room = false);

}  // namespace remeshd
