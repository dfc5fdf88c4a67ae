#pragma once

#include <cstddef>
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
  /// How many tets may be left for the worst to be optimised with their neighbourhoods, x the
  /// number that operations are tried on: where more are, the threshold is out of reach.
  std::size_t most_left = 1;
};

struct ImproveResult {
  TetMesh mesh;  ///< same node indices as the input; nodes no longer used keep their place
  std::vector<std::int32_t> was;  ///< by tet: the input tet with the same nodes, in place; or -1
  std::vector<std::uint8_t> node_moved;  ///< 1 where smoothing moved the node
  /// Tets that are still below the threshold or the least angle. Tets that were not worked on do
  /// not count: neither dirty nor touched, or not near a dirty one where `confined`.
  std::uint32_t below_threshold = 0;
  std::uint32_t bad_at_interface = 0;  ///< those of them with a locked node that score below 0.9
};

/// Removes slivers from a peeled Delaunay mesh by three operations: edge removal over rings, with
/// 2-2 flips and the peeling of lone tets on the boundary (Freitag & Ollivier-Gooch 1997, Shewchuk
/// 2002); face removal (2-3 and 4-4 flips); and local smoothing, in which boundary nodes slide on
/// their surface or curve. Works on tets with `dirty[tet] != 0` that are below the threshold, and
/// on tets that their repair touches.
///
/// The score of a tet tells how near it comes to the threshold in measure and to the least dihedral
/// angle (score.h). Every reconnection and every move of one node raises the worst measure of the
/// tets it touches; on residual tets, which this leaves below the goals, the worst score. Where
/// neither helps, the nodes round a tet take energy descent steps together: the worst score rises,
/// or stays while the sum of the deficits shrinks. Last, such steps and reconnections alternate;
/// the result is taken back unless it is better (aggressive_improvement.h).
///
/// Post: the tets fill the same region, but for what boundary facets on curved faces change; the
/// boundary is a manifold and has the same model edges. The same input gives the same bytes. As a
/// rule no tet scores worse than the worst of the input; it is not certain, because operations by
/// measure do not see angles.
ImproveResult improve(const TetMesh& mesh, std::span<const Support> supports,
                      const BoundaryModel& boundary, std::span<const std::uint8_t> dirty,
                      const ImproveOptions& options, const Run& run);

}  // namespace remeshd
