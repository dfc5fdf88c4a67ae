#include "tests/campaign/contacts.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/base/random.h"

namespace remeshd::campaign {
namespace {

using Kind = Surface::Kind;

constexpr double kTouch = 1e-9;  // of the diagonal: surfaces this near touch
constexpr double kSame = 1e-11;  // of the diagonal: faces this near lie on each other
constexpr double kFilm = 1e-6;   // of the diagonal: faces this near, but no nearer, leave a film
constexpr double kProbe = 1e-6;  // of the diagonal: both sides of a face are looked at this far off
constexpr int kTries = 400;      // points looked at for a common area

Vec3 origin(const Surface& s) { return {s.frame.m[3], s.frame.m[7], s.frame.m[11]}; }
Vec3 axis(const Surface& s) { return {s.frame.m[2], s.frame.m[6], s.frame.m[10]}; }

struct Pair {
  const Surface& a;
  const Surface& b;
  double touch;
  std::vector<Vec3>& points;  ///< where they may touch
};

void near(double gap, const Vec3& at, const Pair& p) {
  if (std::fabs(gap) <= p.touch) p.points.push_back(at);
}

/// Points along a line of contact, all over the box.
void along(double gap, const Vec3& at, const Vec3& direction, double reach, const Pair& p) {
  if (std::fabs(gap) > p.touch) return;
  for (int k = -50; k <= 50; ++k) p.points.push_back(at + (reach * k / 50) * direction);
}

void plane_sphere(const Pair& p) {
  const double d = signed_distance(p.a, origin(p.b));
  near(std::fabs(d) - p.b.r1, project(p.a, origin(p.b)), p);
}

void plane_cylinder(const Pair& p, double reach) {
  if (std::fabs(dot(axis(p.a), axis(p.b))) > 1e-12) return;
  const double d = signed_distance(p.a, origin(p.b));
  along(std::fabs(d) - p.b.r1, project(p.a, origin(p.b)), axis(p.b), reach, p);
}

void plane_torus(const Pair& p) {
  if (norm(cross(axis(p.a), axis(p.b))) > 1e-12) return;
  const double d = signed_distance(p.a, origin(p.b));
  if (std::fabs(std::fabs(d) - p.b.r2) > p.touch) return;
  const Vec3 x{p.b.frame.m[0], p.b.frame.m[4], p.b.frame.m[8]};
  const Vec3 y{p.b.frame.m[1], p.b.frame.m[5], p.b.frame.m[9]};
  for (int k = 0; k < 32; ++k)
    p.points.push_back(
        project(p.a, origin(p.b) + p.b.r1 * (std::cos(0.2 * k) * x + std::sin(0.2 * k) * y)));
}

void cylinder_cylinder(const Pair& p, double reach) {
  const Vec3 u = axis(p.a), v = axis(p.b), w = origin(p.b) - origin(p.a);
  const Vec3 n = cross(u, v);
  if (norm(n) <= 1e-12) {
    const Vec3 off = w - dot(w, u) * u;
    const double d = norm(off);
    if (d <= p.touch) return;
    along(d - p.a.r1 - p.b.r1, origin(p.a) + (p.a.r1 / d) * off, u, reach, p);
    along(d - std::fabs(p.a.r1 - p.b.r1),
          origin(p.a) + (std::copysign(p.a.r1, p.a.r1 - p.b.r1) / d) * off, u, reach, p);
    return;
  }
  // Of skew or crossing axes the common perpendicular carries the contact.
  const Vec3 across = n / norm(n);
  const double d = dot(w, across);
  const double s = dot(cross(w, v), n) / norm2(n);
  for (const double side : {-1.0, 1.0})
    for (const double other : {-1.0, 1.0})
      near(d + other * p.b.r1 - side * p.a.r1, origin(p.a) + s * u + side * p.a.r1 * across, p);
}

void sphere_sphere(const Pair& p) {
  const Vec3 w = origin(p.b) - origin(p.a);
  const double d = norm(w);
  if (d <= p.touch) return;
  near(d - p.a.r1 - p.b.r1, origin(p.a) + (p.a.r1 / d) * w, p);
  near(d - std::fabs(p.a.r1 - p.b.r1),
       origin(p.a) + (std::copysign(p.a.r1, p.a.r1 - p.b.r1) / d) * w, p);
}

void cylinder_sphere(const Pair& p) {
  const Vec3 u = axis(p.a), w = origin(p.b) - origin(p.a);
  const Vec3 foot = origin(p.a) + dot(w, u) * u, off = origin(p.b) - foot;
  const double d = norm(off);
  if (d <= p.touch) {  // a ball in its own pipe: a circle of contact
    if (std::fabs(p.a.r1 - p.b.r1) > p.touch) return;
    const Vec3 x = any_perpendicular(u), y = cross(u, x);
    for (int k = 0; k < 32; ++k)
      p.points.push_back(foot + p.a.r1 * (std::cos(0.2 * k) * x + std::sin(0.2 * k) * y));
    return;
  }
  near(d - p.a.r1 - p.b.r1, foot + (p.a.r1 / d) * off, p);
  near(d - std::fabs(p.a.r1 - p.b.r1), foot + (std::copysign(p.a.r1, p.a.r1 - p.b.r1) / d) * off,
       p);
}

void cylinder_torus(const Pair& p) {
  const Vec3 w = origin(p.b) - origin(p.a);
  if (norm(cross(axis(p.a), axis(p.b))) > 1e-12) return;
  if (norm(w - dot(w, axis(p.a)) * axis(p.a)) > p.touch) return;
  const bool touches = std::fabs(p.b.r1 + p.b.r2 - p.a.r1) <= p.touch ||
                       std::fabs(p.b.r1 - p.b.r2 - p.a.r1) <= p.touch;
  if (!touches) return;
  const Vec3 x = any_perpendicular(axis(p.b)), y = cross(axis(p.b), x);
  for (int k = 0; k < 32; ++k)
    p.points.push_back(origin(p.b) + p.a.r1 * (std::cos(0.2 * k) * x + std::sin(0.2 * k) * y));
}

/// Where the two may touch; kinds in ascending order.
void candidates(const Pair& p, double reach) {
  if (p.a.kind == Kind::Plane) {
    if (p.b.kind == Kind::Sphere) plane_sphere(p);
    if (p.b.kind == Kind::Cylinder) plane_cylinder(p, reach);
    if (p.b.kind == Kind::Torus) plane_torus(p);
  } else if (p.a.kind == Kind::Cylinder) {
    if (p.b.kind == Kind::Cylinder) cylinder_cylinder(p, reach);
    if (p.b.kind == Kind::Sphere) cylinder_sphere(p);
    if (p.b.kind == Kind::Torus) cylinder_torus(p);
  } else if (p.a.kind == Kind::Sphere && p.b.kind == Kind::Sphere) {
    sphere_sphere(p);
  }
}

/// Whether p lies on the solid's own boundary, which has the normal n there.
bool on_boundary(const Solid& solid, const Vec3& p, const Vec3& n, double probe) {
  return solid.contains(p + probe * n) != solid.contains(p - probe * n);
}

/// The same at a point that may lie on an edge: looked at a little to all sides.
bool on_face_or_edge(const Solid& solid, const Vec3& p, const Vec3& n, double probe) {
  const Vec3 x = any_perpendicular(n), y = cross(n, x);
  for (const Vec3& d : {Vec3{}, x, -x, y, -y})
    if (on_boundary(solid, p + 3 * probe * d, n, 2 * probe)) return true;
  return false;
}

bool share_area(const Solid& a, const Solid& b, const Surface& s, double probe) {
  Box box;
  box.lo = {std::max(a.bounds().lo.x, b.bounds().lo.x), std::max(a.bounds().lo.y, b.bounds().lo.y),
            std::max(a.bounds().lo.z, b.bounds().lo.z)};
  box.hi = {std::min(a.bounds().hi.x, b.bounds().hi.x), std::min(a.bounds().hi.y, b.bounds().hi.y),
            std::min(a.bounds().hi.z, b.bounds().hi.z)};
  Random random(7);
  for (int k = 0; k < kTries; ++k) {
    const Vec3 p =
        project(s, {random.uniform(box.lo.x, box.hi.x), random.uniform(box.lo.y, box.hi.y),
                    random.uniform(box.lo.z, box.hi.z)});
    const Vec3 n = normal(s, p);
    if (on_boundary(a, p, n, probe) && on_boundary(b, p, n, probe)) return true;
  }
  return false;
}

}  // namespace

Contacts find_contacts(const FeatureModel& model, const Membership& membership) {
  Contacts result;
  const double diagonal = membership.bounds().diagonal();
  const double touch = kTouch * diagonal, probe = kProbe * diagonal;
  const std::vector<Solid>& solids = membership.solids();
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < model.features.size(); ++i)
    for (std::size_t j = i + 1; j < model.features.size(); ++j) {
      const Box &bi = solids[i].bounds(), &bj = solids[j].bounds();
      if (bi.lo.x > bj.hi.x + touch || bj.lo.x > bi.hi.x + touch || bi.lo.y > bj.hi.y + touch ||
          bj.lo.y > bi.hi.y + touch || bi.lo.z > bj.hi.z + touch || bj.lo.z > bi.hi.z + touch)
        continue;
      bool tangent = false, coincident = false, film = false;
      for (const SolidFace& f : solids[i].faces())
        for (const SolidFace& g : solids[j].faces()) {
          if (same_surface(f.surface, g.surface, bi, kFilm * diagonal)) {
            const bool same = same_surface(f.surface, g.surface, bi, kSame * diagonal);
            bool& kind = same ? coincident : film;
            kind = kind || share_area(solids[i], solids[j], f.surface, same ? probe : 3 * probe);
            continue;
          }
          if (tangent) continue;
          points.clear();
          const bool ordered = f.surface.kind <= g.surface.kind;
          const Pair pair{ordered ? f.surface : g.surface, ordered ? g.surface : f.surface, touch,
                          points};
          candidates(pair, diagonal);
          tangent = std::any_of(points.begin(), points.end(), [&](const Vec3& p) {
            const Vec3 n = normal(f.surface, p);
            return on_face_or_edge(solids[i], p, n, probe) &&
                   on_face_or_edge(solids[j], p, n, probe);
          });
        }
      result.tangent += tangent;
      result.coincident += coincident;
      result.film += film;
    }
  return result;
}

}  // namespace remeshd::campaign
