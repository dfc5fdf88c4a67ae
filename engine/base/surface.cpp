#include "engine/base/surface.h"

#include <algorithm>
#include <cmath>

namespace remeshd {
namespace {

/// A point in cylindrical coordinates about the local z axis; `out` is the unit vector away from
/// the axis, the local x axis for points on it.
struct Meridian {
  double rho = 0;
  double z = 0;
  Vec3 out{1, 0, 0};
};

Meridian meridian(const Vec3& q) {
  const double rho = std::hypot(q.x, q.y);
  if (rho == 0) return {0, q.z, {1, 0, 0}};
  return {rho, q.z, {q.x / rho, q.y / rho, 0}};
}

/// Nearest point of the surface, the normal there and the signed distance, in local coordinates.
struct Foot {
  Vec3 point;
  Vec3 normal;
  double distance = 0;
};

Foot foot_on_cylinder(double radius, const Vec3& q) {
  const Meridian m = meridian(q);
  return {radius * m.out + Vec3{0, 0, q.z}, m.out, m.rho - radius};
}

Foot foot_on_cone(double radius, double slope, const Vec3& q) {
  const Meridian m = meridian(q);
  const double cosine = 1 / std::sqrt(1 + slope * slope);
  const double d = (m.rho - (radius + slope * m.z)) * cosine;
  const Vec3 n = cosine * m.out + Vec3{0, 0, -slope * cosine};
  Foot foot{m.rho * m.out + Vec3{0, 0, m.z} - d * n, n, d};
  if (m.rho - d * cosine < 0) {
    foot.point = {0, 0, -radius / slope};
    foot.distance = distance(q, foot.point);
  }
  return foot;
}

Foot foot_on_sphere(double radius, const Vec3& q) {
  const double d = norm(q);
  const Vec3 n = d == 0 ? Vec3{1, 0, 0} : q / d;
  return {radius * n, n, d - radius};
}

Foot foot_on_torus(double major, double minor, const Vec3& q) {
  const Meridian m = meridian(q);
  const double u = m.rho - major;
  const double d = std::hypot(u, m.z);
  const double nu = d == 0 ? 1 : u / d;
  const double nz = d == 0 ? 0 : m.z / d;
  const double rho = major + minor * nu;
  Foot foot{rho * m.out + Vec3{0, 0, minor * nz}, nu * m.out + Vec3{0, 0, nz}, d - minor};
  if (rho < 0) {
    // A spindle torus ends on the axis: the nearest point is where its meridian meets the axis.
    const double tip = std::copysign(std::sqrt(minor * minor - major * major), m.z);
    foot.point = {0, 0, tip};
    foot.normal = (-major / minor) * m.out + Vec3{0, 0, tip / minor};
    foot.distance = std::copysign(distance(q, foot.point), foot.distance);
  }
  return foot;
}

Vec3 to_local(const Transform& frame, const Vec3& p) {
  const auto& m = frame.m;
  const Vec3 d{p.x - m[3], p.y - m[7], p.z - m[11]};
  return {m[0] * d.x + m[4] * d.y + m[8] * d.z, m[1] * d.x + m[5] * d.y + m[9] * d.z,
          m[2] * d.x + m[6] * d.y + m[10] * d.z};
}

Foot local_foot(const Surface& surface, const Vec3& p) {
  const Vec3 q = to_local(surface.frame, p);
  switch (surface.kind) {
    case Surface::Kind::Plane:
      return {{q.x, q.y, 0}, {0, 0, 1}, q.z};
    case Surface::Kind::Cylinder:
      return foot_on_cylinder(surface.r1, q);
    case Surface::Kind::Cone:
      return foot_on_cone(surface.r1, surface.r2, q);
    case Surface::Kind::Sphere:
      return foot_on_sphere(surface.r1, q);
    case Surface::Kind::Torus:
      return foot_on_torus(surface.r1, surface.r2, q);
  }
  return {};
}

Vec3 origin_of(const Surface& s) { return {s.frame.m[3], s.frame.m[7], s.frame.m[11]}; }
Vec3 axis_of(const Surface& s) { return {s.frame.m[2], s.frame.m[6], s.frame.m[10]}; }

/// Largest distance from plane b of the part of plane a in the box: a linear function on the
/// convex hull of the projected corners, so one of them attains it.
double plane_gap(const Surface& a, const Surface& b, const Box& where) {
  double gap = 0;
  for (const Vec3& c : corners_of(where))
    gap = std::max(gap, std::fabs(signed_distance(b, project(a, c))));
  return gap;
}

/// Bound of the distance between two cones or cylinders along the part of a's axis beside the box:
/// offset of the axes plus difference of the radii, both convex along the axis where no apex is.
double cone_gap(const Surface& a, const Surface& b, const Box& where) {
  const auto radius = [](const Surface& s, double z) {
    return s.kind == Surface::Kind::Cone ? std::fmax(0, s.r1 + s.r2 * z) : s.r1;
  };
  const Vec3 axis = axis_of(a);
  double z_min = HUGE_VAL, z_max = -HUGE_VAL;
  for (const Vec3& c : corners_of(where)) {
    const double z = dot(c - origin_of(a), axis);
    z_min = std::min(z_min, z);
    z_max = std::max(z_max, z);
  }
  double gap = 0;
  for (const double z : {z_min, 0.5 * (z_min + z_max), z_max}) {
    const Vec3 q = to_local(b.frame, origin_of(a) + z * axis);
    gap = std::max(gap, std::hypot(q.x, q.y) + std::fabs(radius(a, z) - radius(b, q.z)));
  }
  return gap;
}

/// Radius of normal curvature along the circle of revolution at a point of such a surface: the
/// length of its normal up to the axis (Meusnier).
double radius_round_axis(const Foot& foot) {
  const double outward = std::hypot(foot.normal.x, foot.normal.y);
  return outward == 0 ? HUGE_VAL : std::hypot(foot.point.x, foot.point.y) / outward;
}

}  // namespace

Vec3 project(const Surface& surface, const Vec3& p) {
  return surface.frame.apply(local_foot(surface, p).point);
}

Vec3 normal(const Surface& surface, const Vec3& p) {
  return surface.frame.rotate(local_foot(surface, p).normal);
}

double signed_distance(const Surface& surface, const Vec3& p) {
  return local_foot(surface, p).distance;
}

double radius_of_curvature(const Surface& surface, const Vec3& p) {
  switch (surface.kind) {
    case Surface::Kind::Plane:
      break;
    case Surface::Kind::Cylinder:
    case Surface::Kind::Sphere:
      return surface.r1;
    case Surface::Kind::Torus:
      return std::fmin(surface.r2, radius_round_axis(local_foot(surface, p)));
    case Surface::Kind::Cone: {
      const Vec3 axis = axis_of(surface), from = p - origin_of(surface);
      return std::sqrt(1 + surface.r2 * surface.r2) * norm(from - dot(from, axis) * axis);
    }
  }
  return HUGE_VAL;
}

bool same_surface(const Surface& a, const Surface& b, const Box& where, double tolerance) {
  using Kind = Surface::Kind;
  const auto conical = [](const Surface& s) {
    return s.kind == Kind::Cone || s.kind == Kind::Cylinder;
  };
  if (conical(a) && conical(b))
    return cone_gap(a, b, where) <= tolerance && cone_gap(b, a, where) <= tolerance;
  if (a.kind != b.kind) return false;
  if (a.kind == Kind::Plane)
    return plane_gap(a, b, where) <= tolerance && plane_gap(b, a, where) <= tolerance;
  const double offset = distance(origin_of(a), origin_of(b)) + std::fabs(a.r1 - b.r1);
  if (a.kind == Kind::Sphere) return offset <= tolerance;
  const double tilt = norm(cross(axis_of(a), axis_of(b))) * (std::fabs(a.r1) + a.r2);
  return offset + std::fabs(a.r2 - b.r2) + tilt <= tolerance;
}

}  // namespace remeshd
