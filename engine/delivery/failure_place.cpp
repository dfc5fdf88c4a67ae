#include "engine/delivery/failure_place.h"

#include <algorithm>
#include <utility>

#include "engine/cellular/boundary_model/face_distance.h"
#include "engine/delivery/facet_names.h"

namespace remeshd {

namespace {

std::vector<int> nearest_faces(const BoundaryModel& boundary, const Vec3& p, double reach) {
  std::vector<std::pair<double, int>> order;
  for (std::size_t f = 0; f < boundary.faces.size(); ++f)
    order.emplace_back(face_distance2(boundary.faces[f], p), static_cast<int>(f));
  std::ranges::sort(order);
  std::vector<int> faces;
  for (std::size_t i = 0; i < std::min<std::size_t>(2, order.size()); ++i)
    if (i == 0 || order[i].first <= reach * reach) faces.push_back(order[i].second);
  return faces;
}

std::vector<int> faces_at(const MeshDefect& defect, const BoundaryModel& boundary, double reach) {
  switch (defect.kind) {
    case MeshFailure::MissingSegment:
      return boundary.edges[defect.entity].faces;
    case MeshFailure::FaceArea:
      return {defect.entity};
    case MeshFailure::Volume:
      return {};
    default:
      return nearest_faces(boundary, defect.place, reach);
    case MeshFailure::MissingVertex:
      break;
  }
  std::vector<int> faces;
  for (const int e : boundary.vertices[defect.entity].edges)
    faces.insert(faces.end(), boundary.edges[e].faces.begin(), boundary.edges[e].faces.end());
  return faces.empty() ? nearest_faces(boundary, defect.place, reach) : faces;
}

void add_once(std::vector<std::string>& list, const std::string& text) {
  if (std::ranges::find(list, text) == list.end()) list.push_back(text);
}

}  // namespace

FailurePlace find_failure(const MeshDefect& defect, const FeatureModel& model,
                          const Membership& membership, const BoundaryModel& boundary,
                          double reach) {
  const FacetNames names(model, membership, boundary);
  FailurePlace place;
  for (const int face : faces_at(defect, boundary, reach)) {
    const std::string name = names(face, defect.place).front();
    add_once(place.faces, name);
    add_once(place.features, name.substr(0, name.find('.')));
  }
  return place;
}

std::string describe(const MeshDefect& defect, const FailurePlace& place) {
  std::string text = defect.what;
  for (std::size_t i = 0; i < place.faces.size(); ++i) {
    if (i == 0) text += place.faces.size() > 1 ? ", between " : ", on ";
    if (i > 0) text += i + 1 == place.faces.size() ? " and " : ", ";
    text += place.faces[i];
  }
  return text;
}

}  // namespace remeshd
