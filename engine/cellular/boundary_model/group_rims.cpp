#include "engine/cellular/boundary_model/group_rims.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/base/tolerance.h"
#include "engine/cellular/boundary_model/support.h"
#include "engine/mesh/grouping.h"

namespace remeshd {
namespace {

/// By face of a feature that groups name: numbers of the groups, each with the condition that it
/// names the face with. What differs in one of them is not selected alike.
using GroupsOfFaces = std::map<FaceName, std::vector<int>>;

GroupsOfFaces groups_of_faces(const FeatureModel& model) {
  GroupsOfFaces found;
  int number = 0;
  for (const FaceGroup& group : model.groups) {
    std::vector<const OpenExpression*> conditions;  // of this group, each once
    for (const SelectedFaces& on : group.on) {
      const auto known = std::ranges::find_if(
          conditions, [&](const OpenExpression* other) { return *other == on.condition; });
      const int of_group = number + static_cast<int>(known - conditions.begin());
      if (known == conditions.end()) conditions.push_back(&on.condition);
      for (const std::string& face : on.faces) found[{on.feature, face}].push_back(of_group);
    }
    number += static_cast<int>(conditions.size());
  }
  return found;
}

/// Whether an edge of the boundary passes through a point.
class OnEdges {
 public:
  OnEdges(const BoundaryModel& boundary, double tolerance)
      : boundary_(boundary), tolerance_(tolerance) {
    for (const BoundaryEdge& edge : boundary.edges) {
      // An arc may stand off its chords.
      double chord = 0;
      for (std::size_t k = 1; k < edge.points.size(); ++k)
        chord = std::fmax(chord, distance(edge.points[k - 1], edge.points[k]));
      boxes_.push_back(grown(box_of(edge.points), tolerance + 0.1 * chord));
    }
  }
  [[nodiscard]] bool operator()(const Vec3& p) const {
    for (std::size_t e = 0; e < boxes_.size(); ++e)
      if (boxes_[e].contains(p) &&
          distance(p, project(boundary_, boundary_.edges[e], p)) <= tolerance_)
        return true;
    return false;
  }

 private:
  const BoundaryModel& boundary_;
  double tolerance_;
  std::vector<Box> boxes_;
};

/// Appends the points of the rims of one boundary that no edge of the other passes through.
void add_rims(const BoundaryModel& of, const BoundaryModel& other,
              const std::function<double(const Vec3&)>& apart, std::vector<Vec3>& places) {
  const double tolerance = 10 * tolerance::kOnSurface * of.bounds.diagonal();
  const OnEdges on_other(other, tolerance);
  for (const BoundaryEdge& edge : of.edges) {
    if (!edge.rim) continue;
    for (std::size_t k = 1; k < edge.points.size(); ++k) {
      const Vec3 &a = edge.points[k - 1], &b = edge.points[k];
      const int steps = std::max(1, static_cast<int>(std::ceil(distance(a, b) / apart(a))));
      // Midpoints of the steps, for the ends of the edge may lie on other edges that meet it.
      for (int s = 0; s < steps; ++s) {
        const Vec3 p = project(of, edge, a + (s + 0.5) / steps * (b - a));
        if (!on_other(p)) places.push_back(p);
      }
    }
  }
}

}  // namespace

std::vector<int> groups_of_pieces(const FeatureModel& model,
                                  const std::vector<BoundaryPiece>& pieces) {
  std::vector<int> numbers(pieces.size(), 0);
  if (model.groups.empty()) return numbers;
  const GroupsOfFaces of_faces = groups_of_faces(model);
  std::map<std::vector<int>, int> sets{{{}, 0}};
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    std::vector<int> groups;
    for (const auto* names : {&pieces[k].material_names, &pieces[k].other_names})
      for (const FaceName& name : *names)
        if (const auto found = of_faces.find(name); found != of_faces.end())
          groups.insert(groups.end(), found->second.begin(), found->second.end());
    sort_unique(groups);
    numbers[k] = sets.try_emplace(groups, static_cast<int>(sets.size())).first->second;
  }
  return numbers;
}

UnifiedEdges unified_edges_of(const kernel::Brep& brep, const std::vector<BoundaryPiece>& pieces,
                              const FeatureModel& model, bool all) {
  const bool boundary = !all;
  std::vector<SelectedFace> faces;
  const std::vector<int> groups = groups_of_pieces(boundary ? model : FeatureModel{}, pieces);
  for (std::size_t f = 0; f < pieces.size(); ++f) {
    SelectedFace face{all || pieces[f].boundary, pieces[f].surface, 1, groups[f]};
    if (boundary && face.selected && !brep.faces[f].triangles.empty()) {
      const bool along = looks_along(brep, brep.faces[f], face.surface);
      face.side = along == pieces[f].outward ? 1 : -1;
    }
    faces.push_back(face);
  }
  return find_unified_edges(brep, faces);
}

std::vector<Vec3> changed_rims(const BoundaryModel& a, const BoundaryModel& b,
                               const std::function<double(const Vec3&)>& apart) {
  std::vector<Vec3> places;
  add_rims(a, b, apart, places);
  add_rims(b, a, apart, places);
  return places;
}

}  // namespace remeshd
