#pragma once

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
  std::uint32_t iterations = 0;  ///< loops; 0: until quality stops improving
  std::uint32_t auto_min = 4, auto_max = 30;
  double auto_gain = 0.002;  ///< improvement of the mean volume-length below which `auto` stops
  /// A free node that moved less than this share of the edge length in an iteration is frozen: it
  /// stays where it is, on the boundary until the last repositioning, and counts as free.
  double freeze = 0.01;
  /// Whether voids between the nodes that a remesh starts with get nodes
  /// (`insert_at_circumcentres`).
  bool insert_at_circumcentres = false;
  /// Whether walls of one to two edge lengths are much of what is meshed. In the first iterations
  /// the boundary pulls in only what is near then, so that some nodes stay in the middle of such a
  /// wall; else all of them go to its sides, with flat tets between.
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
  std::vector<std::int32_t> active_edges;  ///< model edges with such samples, ascending
};

/// The optimisation loop (Sect. 3.3 and 8): the boundary procedure with the active samples,
/// Delaunay mesh, optimal Delaunay relocation (Chen 2003) of the free interior nodes; after
/// iterations 1 and 4 the layer of fixed nodes next to the free ones is freed too. Nodes may be
/// added by splitting, and where `insert_at_circumcentres` finds room for them after iteration 3.
///
/// A first mesh is the case of all nodes free and an empty start. Throws PatchTooSmall where what
/// has to move gets to the interface of the patch.
OptimiseResult optimise(NodeSet& nodes, StartMesh start, const BoundaryModel& boundary,
                        const InsideTest& inside, const Samples& samples,
                        const OptimiseOptions& options, const Run& run);

}  // namespace remeshd
