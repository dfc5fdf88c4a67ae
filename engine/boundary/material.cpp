#include "engine/boundary/material.h"

#include <cmath>
#include <map>
#include <numbers>

#include "engine/mesh/quality.h"

namespace remeshd {
namespace {

/// How often the surface winds about p: 1 in material, 0 outside and in voids (Van Oosterom &
/// Strackee 1983).
double winding_number(const kernel::TetGenSurface& surface, const Vec3& p) {
  double angle = 0;
  for (const auto& t : surface.triangles) {
    const Vec3 a = surface.points[t[0]] - p, b = surface.points[t[1]] - p,
               c = surface.points[t[2]] - p;
    const double la = norm(a), lb = norm(b), lc = norm(c);
    angle += 2 * std::atan2(dot(a, cross(b, c)),
                            la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return angle / (4 * std::numbers::pi);
}

/// By region, whether it is material.
std::map<std::int32_t, bool> find_material(const kernel::TetGenMesh& all,
                                           const kernel::TetGenSurface& surface) {
  std::map<std::int32_t, std::pair<double, Vec3>> largest;  // volume and centroid
  const std::vector<Vec3>& nodes = all.mesh.nodes;
  for (std::size_t t = 0; t < all.mesh.tets.size(); ++t) {
    const Tet& tet = all.mesh.tets[t];
    const double volume = tet_volume(nodes, tet);
    auto& [most, where] = largest[all.regions[t]];
    if (volume <= most) continue;
    most = volume;
    where = centroid(nodes, tet);
  }
  std::map<std::int32_t, bool> material;
  for (const auto& [region, tet] : largest)
    material[region] = tet.first > 0 && winding_number(surface, tet.second) > 0.5;
  return material;
}

}  // namespace

std::vector<Tet> tets_in_material(const kernel::TetGenMesh& filling,
                                  const kernel::TetGenSurface& surface) {
  const std::map<std::int32_t, bool> material = find_material(filling, surface);
  std::vector<Tet> tets;
  for (std::size_t t = 0; t < filling.mesh.tets.size(); ++t)
    if (material.at(filling.regions[t])) tets.push_back(filling.mesh.tets[t]);
  return tets;
}

}  // namespace remeshd
