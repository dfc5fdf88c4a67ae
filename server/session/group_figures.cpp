#include "server/session/group_figures.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "engine/delivery/group_areas.h"

namespace remeshd {
namespace {

/// Facets by group, those of a group one after the other; `begin[g]` is where its first one stands.
struct Sorted {
  std::vector<std::uint32_t> begin, facets;
};

Sorted by_group(const MeshGroups& groups) {
  Sorted out;
  out.begin.resize(groups.facet_groups.size() + 1);
  for (const MeshFacet& facet : groups.facets) ++out.begin[facet.group + 1];
  for (std::size_t g = 1; g < out.begin.size(); ++g) out.begin[g] += out.begin[g - 1];
  out.facets.resize(groups.facets.size());
  std::vector<std::uint32_t> next = out.begin;
  for (std::uint32_t f = 0; f < groups.facets.size(); ++f)
    out.facets[next[groups.facets[f].group]++] = f;
  return out;
}

/// Exact areas of groups, from the faces of the merged boundary. A face that has one name is the
/// group of that name; of a plane that several share, the report tells who has how much.
class ExactAreas {
 public:
  explicit ExactAreas(const Revision& revision) {
    for (const BoundaryFace& face : revision.cells.boundary.faces) {
      std::vector<std::string> names;
      for (const FaceName& name : face.names)
        names.push_back(revision.model.features[name.feature].id + "." + name.face);
      if (names.size() == 1) {
        known_[names.front()] += face.area;
      } else if (face.surface.kind != Surface::Kind::Plane) {
        for (const std::string& name : names) shared_[name].push_back(names);
      }
    }
    for (const GroupArea& group : revision.report.groups) known_[group.group] += group.exact_area;
  }

  /// Nothing where the group may have a part of a face that is no plane and has other names too.
  [[nodiscard]] std::optional<double> of(const std::vector<std::string>& group) const {
    if (const auto found = shared_.find(group.front()); found != shared_.end())
      for (const std::vector<std::string>& names : found->second)
        if (std::ranges::all_of(group, [&](const std::string& name) {
              return std::ranges::find(names, name) != names.end();
            }))
          return std::nullopt;
    const auto area = known_.find(group_name(group));
    if (area == known_.end()) return std::nullopt;
    return area->second;
  }

 private:
  std::unordered_map<std::string, double> known_;  ///< by group
  /// Names of each such face, by each of them.
  std::unordered_map<std::string, std::vector<std::vector<std::string>>> shared_;
};

}  // namespace

std::vector<GroupFigures> group_figures(const Revision& revision) {
  const MeshGroups& groups = revision.output.groups;
  const CowVector<Vec3>& nodes = revision.output.mesh.nodes;
  const Sorted sorted = by_group(groups);
  const ExactAreas exact(revision);
  std::vector<std::int32_t> counted_for(nodes.size(), -1);
  std::vector<GroupFigures> all;
  for (std::int32_t g = 0; g < static_cast<std::int32_t>(groups.facet_groups.size()); ++g) {
    GroupFigures figures;
    figures.group = group_name(groups.facet_groups[g]);
    figures.exact_area = exact.of(groups.facet_groups[g]);
    figures.facets = sorted.begin[g + 1] - sorted.begin[g];
    Vec3 moment, normals;
    for (std::uint32_t k = sorted.begin[g]; k < sorted.begin[g + 1]; ++k) {
      const Triangle& corners = groups.facets[sorted.facets[k]].nodes;
      const Vec3 a = nodes[corners[0]], b = nodes[corners[1]], c = nodes[corners[2]];
      const Vec3 normal = 0.5 * cross(b - a, c - a);
      const double area = norm(normal);
      figures.mesh_area += area;
      moment = moment + (area / 3.0) * (a + b + c);
      normals = normals + normal;
      for (const std::int32_t corner : corners)
        if (std::exchange(counted_for[corner], g) != g) ++figures.nodes;
    }
    if (figures.mesh_area > 0) {
      figures.centroid = moment / figures.mesh_area;
      figures.normal = normals / figures.mesh_area;
    }
    all.push_back(std::move(figures));
  }
  return all;
}

}  // namespace remeshd
