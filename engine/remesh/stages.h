#pragma once

#include <string>
#include <vector>

#include "engine/improve/improve.h"
#include "engine/nodes/node_set.h"
#include "engine/optimise/optimise.h"
#include "engine/plan/point_source.h"
#include "engine/remesh/carry_over.h"
#include "engine/remesh/remesh.h"
#include "engine/verify/verify.h"

namespace remeshd {

/// Target edge length and density of new nodes, as the options ask for and the original gives.
struct Density {
  double edge_length = 0;              ///< l: spacing of samples, reach of searches
  double nodes_per_volume = 0;         ///< in newcells
  std::optional<std::uint32_t> count;  ///< of a first mesh asked for by number of nodes
};

/// Throws Error(InvalidArgument) `OptionsInvalid`.
Density resolve_density(const Revision* original, const MeshOptions& options, double volume,
                        double area);

/// Copied and new nodes, free and fixed (Sects. 6 and 7).
NodeSet initial_nodes(const Revision* original, const PointSource& source, const Density& density,
                      MeshOptions::Start start, std::uint64_t seed, const Run& run);

/// The Delaunay mesh of the fixed nodes that stayed in place, cut out of the original's.
StartMesh start_mesh(const Revision* original, const NodeSet& nodes, const PointSource& source,
                     const Box& bounds, const Run& run);

/// A mesh on its way from the optimisation loop to delivery.
struct Candidate {
  NodeSet nodes;              ///< those of the mesh only
  std::vector<Tet> delaunay;  ///< peeled
  TetMesh mesh;               ///< cleaned up
  OptimiseResult loop;
  NodeMap map;  ///< of `mesh`
  Verification verification;
  bool too_fine = false;  ///< the boundary would need many more nodes than the edge length says
  double verify_seconds = 0;
};

/// What a mesh is made for.
struct Target {
  const Revision* original;  ///< null where everything is new
  const PointSource& source;
  const CellularModel& cells;
  const MeshOptions& options;
};

/// The peeled Delaunay mesh of optimised nodes; nodes in no tet are left out.
Candidate extract(NodeSet nodes, OptimiseResult loop, const CellularModel& cells,
                  const InsideTest& inside, const Run& run);

/// Carrying over, clean-up, map and verification of an extracted mesh.
void finish(Candidate& candidate, const Target& target, const Run& run);

/// The inside test that the options ask for. It keeps a reference to `membership`.
/// Throws what ControlMesh::build throws.
InsideTest inside_test(MeshOptions::Inside kind, const Membership& membership,
                       const BoundaryModel& boundary, const Run& run);

}  // namespace remeshd
