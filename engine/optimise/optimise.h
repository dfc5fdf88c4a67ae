#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/base/inside_test.h"
#include "engine/base/run.h"
#include "engine/boundary/samples.h"
#include "engine/delaunay/delaunay_mesh.h"
#include "engine/nodes/node_set.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

struct OptimiseOptions {
  SizeField sizes{0};            ///< target edge lengths
  std::uint32_t iterations = 0;  ///< of the loop; 0: until quality stops improving
  /// Bounds of the number of iterations where `iterations` is 0.
  std::uint32_t auto_min = 4, auto_max = 30;
  /// Where `iterations` is 0: the loop stops at an iteration in which the mean volume-length
  /// measure (`mean_quality`) gains less than this.
  double auto_gain = 0.002;
  /// A free node that moved less than this share of the edge length in an iteration is frozen: it
  /// stays where it is (one on the boundary until the final boundary procedure) and counts as free.
  double freeze = 0.01;
  /// Voids that a remesh starts with, between its nodes, get new nodes in iteration 3: where a
  /// circumradius, x edge length, is larger than this (large_circumballs.h).
  double largest_ball = HUGE_VAL;
  /// Whether much of what is meshed is walls one to two edge lengths thick. In the first two
  /// iterations the boundary then pulls only on nodes near it, so that some stay in the middle of
  /// such a wall; else all of them would go to its sides, with flat tets between.
  bool thin_walls = false;
  bool rebuild = false;  ///< see LiveMesh
};

/// The Delaunay mesh to start from: that of some of the fixed nodes.
struct StartMesh {
  DelaunayMesh mesh;
  std::vector<std::uint8_t> holds;  ///< by node: 1 if it is in the mesh
};

struct OptimiseResult {
  DelaunayMesh mesh;  ///< of all nodes
  std::vector<std::uint32_t> free_per_iteration;
  std::uint32_t samples_active = 0;        ///< at the end
  std::vector<std::int32_t> active_edges;  ///< with active or border-active samples, ascending
};

/// The optimisation loop (Sect. 3.3 and 8): the boundary procedure with the active samples,
/// Delaunay mesh, optimal Delaunay relocation (Chen 2003) of the free interior nodes; after
/// iteration 1, and in an even size field after iteration 4, the layer of fixed nodes next to the
/// free ones is freed too. Ends with the boundary procedure. Nodes may be added: by splitting, at
/// model vertices without a node, and in voids in iteration 3.
///
/// A first mesh is the case of all nodes free and an empty start. Throws PatchTooSmall where the
/// Delaunay mesh would have to change beyond the interface of the patch.
OptimiseResult optimise(NodeSet& nodes, StartMesh start, const BoundaryModel& boundary,
                        const InsideTest& inside, const Samples& samples,
                        const OptimiseOptions& options, const Run& run);

}  // namespace remeshd
