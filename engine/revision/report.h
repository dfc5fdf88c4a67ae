#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/vec.h"
#include "engine/base/warning.h"
#include "engine/mesh/quality.h"

namespace remeshd {

/// Seconds per phase; the names in Table 3 in brackets. A first mesh fills t1-t3, an edit t4-t8.
struct PhaseSeconds {
  double setup = 0;       ///< [t1, t6] cellular model, membership, samples
  double optimise = 0;    ///< [t2, t7] the loop
  double extract = 0;     ///< [t3, t8] peel, clean-up, groups, maps, verification
  double difference = 0;  ///< [t4] classes by membership, copy order
  double copy = 0;        ///< [t5] copying, new nodes, active faces, free and fixed
  double verify = 0;      ///< verification, as part of the others
  double total = 0;       ///< decoded request to checked mesh with all that the next edit needs
};

struct Counts {
  std::uint32_t nodes = 0, tets = 0, boundary_facets = 0;
  std::uint32_t samples = 0, active_samples = 0;
  std::uint32_t nodes_copied = 0, nodes_new = 0;
  std::uint32_t free_at_start = 0, free_at_end = 0;
  std::vector<std::uint32_t> free_per_iteration;
  std::uint32_t nodes_kept = 0, nodes_moved = 0, tets_kept = 0;
  std::uint32_t iterations = 0;
  std::uint32_t nodes_inserted = 0;  ///< to make the boundary complete
  std::uint32_t mid_nodes = 0;       ///< of tets of second order
  /// Mid-nodes at a curved boundary that were left in the middle of a straight edge, for a tet
  /// would have turned over.
  std::uint32_t straight_edges = 0;
};

/// Which way led to the mesh; a later one is taken where the earlier gave no valid mesh.
enum class MeshStrategy : std::uint8_t {
  Unchanged,  ///< no surface moved: the base's mesh
  Morphed,    ///< the base's connectivity; nodes near moved surfaces follow them
  Local,      ///< what changed was meshed anew; of a first mesh, everything
  Full,       ///< every node was optimised anew, copied ones included
  Fresh,      ///< a regular mesh from new nodes
  TetGen,     ///< TetGen's mesh of the conforming surface
  Renewed,    ///< a regular mesh, in place of a valid remesh whose quality had drifted
};

/// An attempt as the report tells it: of a strategy at the mesh, or of a route to the boundary.
struct TriedStrategy {
  std::string strategy;  ///< in full, as `local, 4 edge lengths`
  std::string reason;    ///< why it was not taken; empty where it was
  double seconds = 0;
};

/// A group of facets on a plane model face with several names. A seam between coplanar feature
/// faces is no model edge, so facets may cross it and cover the group's part of the face only
/// roughly.
struct GroupArea {
  std::string group;  ///< `plate.top`
  double exact_area = 0;
  double mesh_area = 0;
};

/// What became of a group since the parent. In the protocol GroupAudit.State.
enum class GroupState : std::uint8_t {
  Unspecified,  ///< of a first mesh
  Same,
  Resized,  ///< of another exact area
  Split,    ///< into more parts that do not touch
  Merged,   ///< parts of it touch now, or it shares facets with a group that it shared none with
  Emptied,  ///< it selects nothing any more
  New,
};

/// A group of the model, or a group of facets: its exact area, what the mesh has of it, and what
/// became of it since the parent.
struct GroupFigures {
  std::string group;  ///< a name of the model's, or the faces of a group of facets, joined by `+`
  bool of_model = false;  ///< a group of the model
  GroupState state = GroupState::Unspecified;
  /// Of what it selects of the boundary, under a condition by quadrature; empty where the engine
  /// does not know it.
  std::optional<double> exact_area;
  double mesh_area = 0;
  Vec3 centroid;  ///< of the facets
  Vec3 normal;    ///< mean of the facets' outward ones, weighted by area; 1 long for a plane
  std::uint32_t nodes = 0, facets = 0, tets = 0;
  std::uint32_t parts = 0;  ///< that the facets fall into, without common nodes
};

/// What verification measured of a mesh that it found valid.
struct VerificationFigures {
  std::uint32_t tets_proved = 0;     ///< by themselves: new ones and those with a node that moved
  std::uint32_t tets_inherited = 0;  ///< by the base's verification, of tets that are unchanged
  double chord_error = 0;   ///< largest distance of a boundary facet or edge from its face or curve
  double volume_error = 0;  ///< relative, with the volume between facets and curved faces added
};

/// What a run did. Everything but seconds, those of attempts too, is the same for the same request.
struct Report {
  std::string revision;  ///< set by the session
  bool cached = false;   ///< set by the session
  MeshStrategy strategy = MeshStrategy::Local;
  std::vector<TriedStrategy> attempts;  ///< those not taken, in the order tried
  TriedStrategy taken;                  ///< the one that made the mesh
  PhaseSeconds seconds;
  Counts counts;
  double free_share = 1;  ///< mean over the iterations; frozen nodes count as free
  double edge_length = 0;
  double volume = 0, exact_volume = 0;
  Quality quality_before;  ///< of the peeled Delaunay mesh
  Quality quality;         ///< as delivered
  /// The same without the tets with a corner where the model itself has an angle below 25 degrees
  /// (a wedge of material, or edges of one face that meet sharply or touch) and, in a sized mesh,
  /// those across a wall thinner than the least size.
  Quality quality_away;
  std::uint32_t sharp_tets = 0;  ///< tets that `quality_away` leaves out
  VerificationFigures verification;
  std::vector<GroupArea> groups;
  std::vector<GroupFigures> figures;  ///< of all groups: those of facets, then those of the model
  /// Share of the tets that a last resort (TetGen) made: 1 for its own mesh; of an edit, the base's
  /// share of those that it keeps.
  double last_resort_share = 0;
  std::string geometry;  ///< how the boundary was made: BoundaryParts::geometry
  double geometry_seconds = 0;
  std::vector<TriedStrategy> geometry_attempts;  ///< routes to it given up, in the order tried
  std::vector<Warning> warnings;
};

}  // namespace remeshd
