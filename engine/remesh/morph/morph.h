#pragma once

#include <string>
#include <variant>

#include "engine/revision/revision.h"
#include "engine/verify/verify.h"

namespace remeshd {

/// The edge length l is the least of the original's size field.
struct MorphLimits {
  double surface_motion = 0.01;  ///< x edge length
  /// x edge length: where the cheap upper bound of surface motions (`motion_bound`) is more, they
  /// are not measured, and the mesh is not morphed.
  double motion_bound = 0.05;
  double partner_reach = 0.1;  ///< x edge length: from an entity to its partner, at most
  double influence = 2.9;      ///< x edge length: interior nodes this near may move
  double leverage = 5;         ///< node motion over surface motion
  /// x the CAD kernel's tolerance. The kernel takes faces this near to each other for one and draws
  /// edges on either, so that an edge may move by this with a hidden face, though no face of the
  /// boundary moves.
  double coincident = 0.5;
  int sweeps = 24;             ///< of the harmonic extension, there and back
  double quality_loss = 1e-3;  ///< rad, and volume-length: a loss so small is allowed
};
inline constexpr MorphLimits kMorphLimits;

/// The mesh of a revision whose nodes have followed a small motion of the surfaces.
struct MorphedMesh {
  PagedMesh mesh;  ///< the tets of the base
  CowVector<Support> supports;
  Verification verification;
  double verify_seconds = 0;
  std::uint32_t nodes_moved = 0;  ///< against the anchor
};

/// Why the connectivity cannot be kept; empty where the change is too large to expect that it can.
using NotMorphed = std::string;

/// Keeps the connectivity of `original` for a model whose surfaces are less than 0.01 l from where
/// they were when that connectivity was made (the anchor), with the same topology. Every node is
/// placed anew from where it was then, so that any number of steps ends where one step would:
/// boundary nodes go to the nearest point of their surface, curve or vertex, and interior nodes
/// within 2.9 l of one that moved share the motion by a discrete harmonic extension. No node moves
/// further than the greater of two lengths: five times the largest distance of an anchor position
/// from its surface now, and the distance by which an edge may move with a hidden face
/// (`coincident`).
///
/// Post: the mesh is valid; a tet that met the goals of quality at the anchor (least dihedral angle
/// 25 degrees, largest 145, volume-length 0.42) meets them still, any other lost next to nothing.
std::variant<MorphedMesh, NotMorphed> morph_mesh(const Revision& original, const Revision& modified,
                                                 const Run& run);

/// Verifies a mesh of `modified` that has the tets of `original`, its nodes moved. Returns the mesh
/// with its verification, or its first defect where it is not valid.
std::variant<MorphedMesh, NotMorphed> verified(MorphedMesh moved, const Revision& original,
                                               const Revision& modified, const Run& run);

}  // namespace remeshd
