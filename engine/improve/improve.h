#pragma once

#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "engine/base/run.h"
#include "engine/cellular/boundary_model/support.h"
#include "engine/mesh/quality_goals.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

struct ImproveOptions {
  /// Tets below this volume-length measure are worked on, worst first.
  double threshold = goals::kThreshold;
  /// rad; tets with a smaller dihedral angle are worked on, too. Few of fair measure have one, so
  /// that this costs less than a higher threshold for all.
  double min_dihedral = 25.2 * std::numbers::pi / 180;
  int max_ring = 8;  ///< largest ring of tets round an edge that edge removal tries
  int passes = 4;    ///< sweeps over what is still below the threshold
  /// A sliding boundary node or a swapped boundary edge may raise the distance between boundary
  /// facets and their surface by at most this share of the local edge length.
  double chord_tolerance = 0.05;
  /// Nodes with smaller numbers are interface nodes of a patch: they stay, and so does the hull
  /// between them.
  std::int32_t locked = 0;
  /// Whether only tets that share a node with a dirty one are worked on, and those of them that are
  /// not dirty only once they score worse than in the input. Else a tet that was bad all along,
  /// once a repair has touched it, is repaired in its turn, and so on: where a thin wall has many
  /// such tets clean-up wanders through all of the patch.
  bool confined = false;
};

struct ImproveResult {
  TetMesh mesh;  ///< same node indices as the input; nodes no longer used keep their place
  std::vector<std::int32_t> was;  ///< by tet: the input tet with the same nodes, in place; or -1
  std::vector<std::uint8_t> node_moved;  ///< 1 where smoothing moved the node
  std::uint32_t below_threshold = 0;     ///< tets still below the threshold or the least angle
  std::uint32_t bad_at_interface = 0;    ///< those of them with a locked node that score below 0.9
};

/// Removes slivers from a peeled Delaunay mesh: edge removal over rings (Freitag & Ollivier-Gooch
/// 1997, Shewchuk 2002), face removal (2-3, 4-4 flips, 2-2 and peeling of flat tets on the
/// boundary) and local smoothing in which boundary nodes slide on their surface or curve. Works on
/// tets with `dirty[tet] != 0` that are below the threshold and on what their repair touches. A tet
/// scores by how near it comes to the threshold in measure and to the least dihedral angle; every
/// reconnection and every move of one node raises the worst measure, or on residual tets the worst
/// score, of the tets it touches. Where neither helps, the nodes round a tet take energy descent
/// steps together, which may leave the worst as it is while the sum of the deficits shrinks; at
/// last such steps and reconnections take turns, which is taken back unless the outcome is better
/// (aggressive_improvement.h).
///
/// Post: volume covered, boundary manifold and its model edges as before; the same input gives the
/// same bytes. Operations by measure do not see angles, so that only as a rule no tet scores worse
/// than the worst of the input.
ImproveResult improve(const TetMesh& mesh, std::span<const Support> supports,
                      const BoundaryModel& boundary, std::span<const std::uint8_t> dirty,
                      const ImproveOptions& options, const Run& run);

}  // namespace remeshd
