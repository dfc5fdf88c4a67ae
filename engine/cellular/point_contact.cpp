#include "engine/cellular/point_contact.h"

#include <cmath>

namespace remeshd {
namespace {

constexpr double kStep = 1e-2;  // x the sphere's radius: from the contact to the points probed

/// Whether both surfaces are boundary all round their point of contact: at four places about it the
/// nature between them differs from that beyond each.
bool parts_sheets(const Membership& membership, const Surface& sphere, const Surface& other,
                  const Vec3& contact, double tolerance) {
  const Vec3 n = normal(sphere, contact);
  const Vec3 u = any_perpendicular(n), v = cross(n, u);
  for (const double angle : {0.3, 1.9, 3.5, 5.1}) {
    const Vec3 p = contact + kStep * sphere.r1 * (std::cos(angle) * u + std::sin(angle) * v);
    const Vec3 a = project(sphere, p), b = project(other, p);
    if (distance(a, b) < 2 * tolerance) return false;  // they touch along a curve
    const bool between = membership.inside(0.5 * (a + b));
    if (membership.inside(a + 0.5 * (a - b)) == between ||
        membership.inside(b + 0.5 * (b - a)) == between)
      return false;
  }
  return true;
}

}  // namespace

std::optional<Vec3> find_point_contact(const Membership& membership, double tolerance) {
  const std::vector<Solid>& solids = membership.solids();
  for (std::size_t i = 0; i < solids.size(); ++i)
    for (const SolidFace& face : solids[i].faces()) {
      const Surface& sphere = face.surface;
      if (sphere.kind != Surface::Kind::Sphere) continue;
      const Vec3 centre = sphere.frame.apply({0, 0, 0});
      for (std::size_t j = 0; j < solids.size(); ++j) {
        if (i == j) continue;
        for (const SolidFace& other : solids[j].faces()) {
          const Vec3 q = project(other.surface, centre);
          if (std::fabs(distance(q, centre) - sphere.r1) <= tolerance &&
              parts_sheets(membership, sphere, other.surface, q, tolerance))
            return q;
        }
      }
    }
  return std::nullopt;
}

}  // namespace remeshd
