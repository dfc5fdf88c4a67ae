#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/boundary/samples.h"
#include "engine/extract/peel.h"
#include "engine/improve/improve.h"
#include "engine/nodes/node_set.h"
#include "engine/optimise/optimise.h"
#include "engine/plan/point_source.h"
#include "engine/remesh/part.h"
#include "engine/remesh/remesh.h"
#include "engine/remesh/splice.h"
#include "engine/verify/verify.h"

namespace remeshd {

/// Target edge length and density of new nodes, as the options ask for and the original gives.
struct Density {
  double edge_length = 0;              ///< l: spacing of samples, reach of searches
  double nodes_per_volume = 0;         ///< in newcells
  std::optional<std::uint32_t> count;  ///< of a first mesh asked for by number of nodes
  bool inherited = false;              ///< an edit keeps its base's density
};

/// Throws Error(InvalidArgument): `OPTIONS_INVALID`; `MESH_TOO_LARGE` where a mesh of this density
/// would need more nodes than `run.max_nodes`.
Density resolve_density(const Revision* original, const MeshOptions& options,
                        const CellularModel& cells, const Run& run);

/// How far from what changes an edit cuts the original open, and how it places boundary nodes.
struct Reach {
  double length = 0;  ///< infinite: everywhere
  const EntityMap* map = nullptr;
};

/// Copied and new nodes, free and fixed (Sects. 6 and 7), with the part of the original that they
/// are put into. Returns nothing where the reach does not do.
std::optional<LocalNodes> initial_nodes(const Revision* original, const PointSource& source,
                                        const Density& density, MeshOptions::Start start,
                                        std::uint64_t seed, const Reach& reach, const Run& run);

/// Where an edit needs samples of the boundary: near its free nodes, with those that get free
/// beside them, and near fixed nodes that have to find what they stand on.
std::vector<Region> sampled_places(const LocalNodes& local, double edge_length, const Reach& reach);

/// The Delaunay mesh of the fixed nodes that stayed in place, cut out of the original's.
/// Throws LeftPart.
StartMesh start_mesh(const LocalNodes& local, const PointSource& source, const Box& bounds,
                     const Run& run);

/// A mesh on its way from the optimisation loop to delivery.
struct Candidate {
  NodeSet nodes;        ///< those of the part's mesh only
  PeeledMesh delaunay;  ///< of the part
  OptimiseResult loop;
  WholeMesh whole;
  Verification verification;  ///< of the whole
  bool too_fine = false;      ///< the boundary would need many more nodes than the edge length says
  std::uint32_t bad_at_rim =
      0;  ///< tets that the clean-up could not mend, beside what is not in the part
  double verify_seconds = 0;
  std::vector<Attempt> given_up;  ///< on the way to it, by a strategy that has several tries
};

/// What a mesh is made for.
struct Target {
  const Revision* original;  ///< null where everything is new
  const PointSource& source;
  const CellularModel& cells;
  const MeshOptions& options;
};

/// What an edit works on: the part of the original, and what is left of it.
struct Site {
  const OriginalPart& part;
  const EntityMap* map;  ///< for nodes that are not in the part; null where all are
};

/// The peeled Delaunay mesh of optimised nodes; nodes in no tet are left out. Throws LeftPart.
Candidate extract(NodeSet nodes, OptimiseResult loop, const OriginalPart& part,
                  const PointSource& source, const CellularModel& cells, const InsideTest& inside,
                  const Run& run);

/// Carrying over, clean-up, putting back into the original, map and verification of an extracted
/// mesh. `clean_up`: false for a draft, to see whether the boundary is all there. Throws LeftPart.
void finish(Candidate& candidate, const Target& target, const Site& site, bool clean_up,
            const Run& run);

/// The inside test that the options ask for. It keeps a reference to `membership`.
/// Throws what ControlMesh::build throws.
InsideTest inside_test(MeshOptions::Inside kind, const Membership& membership,
                       const BoundaryModel& boundary, const Run& run);

}  // namespace remeshd
