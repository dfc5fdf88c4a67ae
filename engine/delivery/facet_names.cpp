#include "engine/delivery/facet_names.h"

#include <algorithm>
#include <cmath>

#include "engine/base/tolerance.h"

namespace remeshd {

FacetNames::FacetNames(const FeatureModel& model, const Membership& membership,
                       const BoundaryModel& boundary)
    : model_(model),
      membership_(membership),
      boundary_(boundary),
      tolerance_(tolerance::kOnSurface * boundary.bounds.diagonal()) {}

std::vector<std::string> FacetNames::operator()(int face_index, const Vec3& p) const {
  const BoundaryFace& face = boundary_.faces[face_index];
  std::vector<FaceName> here;
  if (face.names.size() == 1) {
    here = face.names;
  } else {
    const Vec3 c = project(face.surface, p);
    const Vec3 outward = outward_normal(face, c);
    std::vector<FaceName> beyond;  // on the far side: faces of subtractive features
    for (const FaceName& name : face.names) {
      const bool material = membership_.contains(name.feature, c - tolerance_ * outward);
      if (material == membership_.contains(name.feature, c + tolerance_ * outward)) continue;
      if (!passes(name, c)) continue;
      (material ? here : beyond).push_back(name);
    }
    const auto latest_first = [](const FaceName& a, const FaceName& b) {
      return a.feature != b.feature ? a.feature > b.feature : a.face < b.face;
    };
    std::sort(here.begin(), here.end(), latest_first);
    std::sort(beyond.begin(), beyond.end(), latest_first);
    here.insert(here.end(), beyond.begin(), beyond.end());
    if (here.empty()) here.push_back(face.names.front());  // on a seam, to within rounding
  }
  std::vector<std::string> names;
  for (const FaceName& name : here)
    names.push_back(model_.features[name.feature].id + "." + name.face);
  return names;
}

bool FacetNames::passes(const FaceName& name, const Vec3& p) const {
  const auto& faces = membership_.solids()[name.feature].faces();
  return std::any_of(faces.begin(), faces.end(), [&](const SolidFace& f) {
    return f.name == name.face && std::fabs(signed_distance(f.surface, p)) <= tolerance_;
  });
}

}  // namespace remeshd
