#include "engine/delivery/group_areas.h"

#include <algorithm>
#include <map>

#include "engine/base/tolerance.h"
#include "engine/cellular/boundary_model/boundary_parts.h"
#include "engine/cellular/boundary_model/face_distance.h"
#include "engine/delivery/facet_names.h"
#include "engine/revision/group_figures.h"

namespace remeshd {

namespace {

/// A point well inside a piece of the boundary, on its triangulation.
Vec3 point_on(const kernel::Brep& brep, const kernel::BrepFace& face) {
  const auto& p = brep.points;
  const auto size = [&](const auto& t) { return triangle_area(p[t[0]], p[t[1]], p[t[2]]); };
  const auto largest =
      std::max_element(face.triangles.begin(), face.triangles.end(),
                       [&](const auto& a, const auto& b) { return size(a) < size(b); });
  return (p[(*largest)[0]] + p[(*largest)[1]] + p[(*largest)[2]]) / 3.0;
}

/// The plane face with several names that a point of the merged boundary is on; -1: none.
int shared_plane(const BoundaryModel& boundary, const Membership& membership, const Vec3& p) {
  // Wider than for nodes: the middle of a triangle is on a chord, and so may be further off.
  const double tolerance = 10 * tolerance::kOnSurface * boundary.bounds.diagonal();
  for (int f = 0; f < static_cast<int>(boundary.faces.size()); ++f) {
    const BoundaryFace& face = boundary.faces[f];
    if (face.names.size() < 2 || face.surface.kind != Surface::Kind::Plane ||
        std::fabs(signed_distance(face.surface, p)) > tolerance ||
        face_distance2(face, p) > tolerance * tolerance)
      continue;
    const Vec3 out = tolerance * outward_normal(face, p);
    if (membership.inside(p - out) && !membership.inside(p + out)) return f;
  }
  return -1;
}

}  // namespace

std::vector<GroupArea> group_areas(const PagedMesh& mesh, const MeshGroups& groups,
                                   const FeatureModel& model, const Membership& membership,
                                   const CellularModel& cells) {
  const FacetNames names(model, membership, cells.boundary);
  std::map<std::vector<std::string>, double> exact;
  for (const kernel::BrepFace& face : cells.parts->brep.faces) {
    if (face.triangles.empty()) continue;
    const Vec3 p = point_on(cells.parts->brep, face);
    const int plane = shared_plane(cells.boundary, membership, p);
    if (plane >= 0) exact[names(plane, p)] += face.area;
  }
  if (exact.empty()) return {};
  std::vector<double> meshed(groups.facet_groups.size(), 0.0);
  for (const MeshFacet& f : groups.facets)
    meshed[f.group] +=
        triangle_area(mesh.nodes[f.nodes[0]], mesh.nodes[f.nodes[1]], mesh.nodes[f.nodes[2]]);
  std::vector<GroupArea> result;
  for (const auto& [group, amount] : exact) {
    const auto at = std::lower_bound(groups.facet_groups.begin(), groups.facet_groups.end(), group);
    const bool found = at != groups.facet_groups.end() && *at == group;
    result.push_back(
        {group_name(group), amount, found ? meshed[at - groups.facet_groups.begin()] : 0.0});
  }
  return result;
}

}  // namespace remeshd
