#pragma once

#include "engine/base/vec.h"

namespace remeshd {

/// The five surfaces that bound the features of this system.
///
/// `frame` places the local surface in the world: its columns are the local axes, its last column
/// the local origin.
///   Plane     z = 0, normal +z
///   Cylinder  axis z, radius r1
///   Cone      axis z, radius r1 >= 0 at z = 0, slope dr/dz = r2; it ends at its apex, z = -r1/r2
///   Sphere    centre at the origin, radius r1
///   Torus     axis z, major radius r1, minor radius r2. Where |r1| < r2 it is the part of the
///             spindle torus that its meridian circle, centred r1 from the axis, sweeps on its own
///             side of the axis: the outer part for r1 > 0, the inner one (a lemon) for r1 < 0.
struct Surface {
  enum class Kind { Plane, Cylinder, Cone, Sphere, Torus };
  Kind kind = Kind::Plane;
  Transform frame;
  double r1 = 0;
  double r2 = 0;
};

/// Nearest point on the (untrimmed) surface. On an axis or at a centre, where many are nearest,
/// it is the one along the local x axis.
Vec3 project(const Surface& surface, const Vec3& p);

/// Unit normal at the point of the surface nearest to p: +z of a plane, away from the axis, the
/// centre or the tube's centre circle otherwise.
Vec3 normal(const Surface& surface, const Vec3& p);

/// Distance to the surface, positive on the side that `normal` points to.
double signed_distance(const Surface& surface, const Vec3& p);

/// Smallest radius of curvature at the point nearest to p; infinite on a plane, 0 at the apex of a
/// cone and where a spindle torus meets its axis. On a cone p itself is taken for the nearest
/// point: it should lie on the surface or close to it.
double radius_of_curvature(const Surface& surface, const Vec3& p);

/// Whether two surfaces are the same point set to within `tolerance` (length) in the box given.
bool same_surface(const Surface& a, const Surface& b, const Box& where, double tolerance);

}  // namespace remeshd
