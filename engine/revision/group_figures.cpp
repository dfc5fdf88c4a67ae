#include "engine/revision/group_figures.h"

#include <algorithm>
#include <span>
#include <unordered_map>
#include <utility>

#include "engine/base/union_find.h"
#include "engine/mesh/grouping.h"

namespace remeshd {
namespace {

/// Exact areas of groups of facets. The area of a boundary face with one name belongs to the group
/// of that name; how planes with several names are shared out is in `Report::groups`.
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

  /// Nothing where the group may have a part of a curved face with several names.
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
  /// By name: the name lists of the curved faces that have it and other names.
  std::unordered_map<std::string, std::vector<std::vector<std::string>>> shared_;
};

/// Counts and measures sets of facets of one mesh.
class FacetCounter {
 public:
  explicit FacetCounter(const OutputMesh& output)
      : groups_(output.groups),
        nodes_(output.mesh.nodes),
        counted_for_(nodes_.size(), -1),
        local_(nodes_.size()) {}

  void count(std::span<const std::int32_t> facets, GroupFigures& figures) {
    ++set_;
    figures.facets = static_cast<std::uint32_t>(facets.size());
    Vec3 moment, normals;
    for (const std::int32_t f : facets) {
      const Triangle& corners = groups_.facets[f].nodes;
      const Vec3 a = nodes_[corners[0]], b = nodes_[corners[1]], c = nodes_[corners[2]];
      const Vec3 normal = 0.5 * cross(b - a, c - a);
      const double area = norm(normal);
      figures.mesh_area += area;
      moment = moment + (area / 3.0) * (a + b + c);
      normals = normals + normal;
      for (const std::int32_t corner : corners)
        if (std::exchange(counted_for_[corner], set_) != set_) local_[corner] = figures.nodes++;
    }
    if (figures.mesh_area > 0) {
      figures.centroid = moment / figures.mesh_area;
      figures.normal = normals / figures.mesh_area;
    }
    figures.parts = parts(facets, figures.nodes);
  }

 private:
  /// Number of parts without a common node that the facets counted last fall into.
  [[nodiscard]] std::uint32_t parts(std::span<const std::int32_t> facets,
                                    std::uint32_t nodes) const {
    UnionFind joined(nodes);
    std::uint32_t parts = nodes;
    for (const std::int32_t f : facets) {
      const Triangle& t = groups_.facets[f].nodes;
      for (const int other : {t[1], t[2]}) {
        const auto a = static_cast<int>(local_[t[0]]), b = static_cast<int>(local_[other]);
        if (joined.find(a) == joined.find(b)) continue;
        joined.join(a, b);
        --parts;
      }
    }
    return parts;
  }

  const MeshGroups& groups_;
  const CowVector<Vec3>& nodes_;
  std::vector<std::int32_t> counted_for_;  ///< by node: the last set that it was counted for
  std::vector<std::uint32_t> local_;       ///< by node: its number in that set
  std::int32_t set_ = -1;
};

}  // namespace

std::vector<GroupFigures> group_figures(const Revision& revision,
                                        std::span<const GroupFigures> of_model) {
  const MeshGroups& groups = revision.output.groups;
  const auto by_group = grouped<std::int32_t>(groups.facet_groups.size(), [&](const auto& visit) {
    for (std::size_t f = 0; f < groups.facets.size(); ++f)
      visit(groups.facets[f].group, static_cast<std::int32_t>(f));
  });
  const ExactAreas exact(revision);
  FacetCounter counter(revision.output);
  std::vector<GroupFigures> all;
  for (std::size_t g = 0; g < groups.facet_groups.size(); ++g) {
    GroupFigures& figures = all.emplace_back();
    figures.group = group_name(groups.facet_groups[g]);
    figures.exact_area = exact.of(groups.facet_groups[g]);
    counter.count(by_group[g], figures);
  }
  for (const GroupMembers& group : groups.of_model) {
    GroupFigures& figures = all.emplace_back();
    figures.group = group.name;
    figures.of_model = true;
    const auto known = std::ranges::find(of_model, group.name, &GroupFigures::group);
    if (known != of_model.end()) figures.exact_area = known->exact_area;
    figures.tets = static_cast<std::uint32_t>(group.tets.size());
    counter.count(group.facets, figures);
  }
  return all;
}

}  // namespace remeshd
