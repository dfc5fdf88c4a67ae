#pragma once

#include <span>
#include <vector>

#include "engine/local_fuse/arrangement/sweeps.h"

namespace remeshd {

/// A face of a swept feature: a cap at its bottom or top, or the wall, flat or round, that a side
/// of its outline sweeps.
struct Patch {
  int feature = -1;
  const SolidFace* face = nullptr;
  bool cap = false, round = false;
  Box box;

  Vec3 origin, normal;       ///< of a plane; outward
  Vec3 from, along;          ///< of a flat wall: start and unit direction of its bottom side
  double length = 0;         ///< of a flat wall, along
  Transform into;            ///< of a round wall: into the cylinder's frame
  double radius = 0;         ///< of a round wall
  double first = 0;          ///< of a round wall: angle (rad) about its axis where it begins,
  double angle = 0;          ///< and how far it reaches from there; 2 pi all round
  double low = 0, high = 0;  ///< of a round wall: along its axis

  [[nodiscard]] bool closed() const;  ///< a whole cylinder, with a seam at `first`
  [[nodiscard]] Vec3 axis() const { return {into.m[8], into.m[9], into.m[10]}; }
  [[nodiscard]] double distance_to(const Vec3& p) const;  ///< signed, from the untrimmed surface
  [[nodiscard]] Vec3 normal_at(const Vec3& p) const;      ///< of the surface
  /// The angle about the axis from where a round wall begins to a point, rad, in [0, 2 pi].
  [[nodiscard]] double angle_at(const Vec3& p) const;
  /// Whether a point of the surface lies, to within `tolerance` (a length), between the two upright
  /// borders of a wall, at whatever height; always true of a cap or a closed wall.
  [[nodiscard]] bool beside(const Vec3& p, double tolerance) const;
};

/// An edge of a feature itself, or a seam.
struct PatchEdge {
  int feature = -1;
  Vec3 from, to;
  int wall = -1;  ///< of an arc: the round wall whose border it is; else -1
  int seam = -1;  ///< of a seam: the closed wall that begins and ends there; else -1
};

struct Patches {
  std::vector<Patch> patches;
  std::vector<PatchEdge> edges;
};

/// The faces of features each of which is swept along a direction of its own. Gives up where one is
/// not swept.
///
/// Pre: the membership is the model's.
Tried<Patches> find_patches(const FeatureModel& model, const Membership& membership,
                            std::span<const int> features);

}  // namespace remeshd
