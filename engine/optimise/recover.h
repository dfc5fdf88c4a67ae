#pragma once

#include <cstdint>
#include <vector>

#include "engine/nodes/node_set.h"
#include "engine/optimise/live_mesh.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

struct RecoverOptions {
  SizeField sizes{0};  ///< target edge lengths
  int rounds = 12;     ///< at most
  /// So many nodes at most, as a share of those there are, and 200 more: two model edges much
  /// nearer to each other than the edge length would split each other into pieces as short as that.
  double most = 0.2;
  /// Edges that have to have nodes, ascending. In a patch of a mesh others may have theirs
  /// elsewhere.
  std::vector<std::int32_t> wanted;
  /// By model edge: links that it has to have; empty: any number does.
  std::vector<int> fewest_links;
};

/// Makes model edges present that the optimisation left missing: a model edge has to be a chain of
/// mesh edges between its nodes (Sect. 3.4), and where one link is not in the Delaunay mesh, a node
/// is inserted into it; where there are too few links, the longest are halved. Near a model vertex
/// the insertion keeps to shells of radius l / 2^k round it, so that edges meeting at a sharp angle
/// do not split each other for ever (Ruppert 1995).
///
/// Post: `live` follows the nodes; links are still missing where `rounds` or `most` did not do.
/// Returns the number of nodes inserted.
int recover_edges(NodeSet& nodes, const BoundaryModel& boundary, LiveMesh& live,
                  const RecoverOptions& options);

}  // namespace remeshd
