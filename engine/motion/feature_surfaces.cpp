#include "engine/motion/feature_surfaces.h"

#include <algorithm>
#include <cmath>

#include "engine/base/tolerance.h"

namespace remeshd {
namespace {

using Ref = FeatureSurfaces::Ref;

/// Whether all the points lie on a surface.
bool lies_on(const Surface& surface, std::span<const Vec3> points, double tolerance) {
  return std::ranges::all_of(
      points, [&](const Vec3& p) { return std::fabs(signed_distance(surface, p)) <= tolerance; });
}

/// Whether a solid holds p or one of 26 points round it, up to `near` away along each axis.
bool touches(const Solid& solid, const Vec3& p, double near) {
  if (!solid.bounds().contains(p, near)) return false;
  for (const double x : {-near, 0.0, near})
    for (const double y : {-near, 0.0, near})
      for (const double z : {-near, 0.0, near})
        if (solid.contains(p + Vec3{x, y, z})) return true;
  return false;
}

/// The faces on whose surfaces all the points lie, of the features that touch `one` of them.
std::vector<Ref> touched(std::span<const Vec3> points, const Vec3& one, const FacesOfModel& faces,
                         const Membership& membership, double near) {
  std::vector<Ref> out;
  for (int feature = 0; feature < static_cast<int>(faces.size()); ++feature) {
    if (!touches(membership.solids()[feature], one, near)) continue;
    const auto& of_feature = faces.of(feature);
    for (std::size_t k = 0; k < of_feature.size(); ++k)
      if (lies_on(of_feature[k].surface, points, near))
        out.push_back({feature, static_cast<int>(k)});
  }
  return out;
}

void unite(std::vector<Ref>& all) {
  std::ranges::sort(all);
  all.erase(std::ranges::unique(all).begin(), all.end());
}

}  // namespace

FacesOfModel::FacesOfModel(const FeatureModel& model) {
  faces_.reserve(model.features.size());
  for (const Feature& feature : model.features) faces_.push_back(faces_of(feature));
}

const Surface* FacesOfModel::find(const Ref& ref) const {
  if (ref.feature >= static_cast<int>(faces_.size())) return nullptr;
  const auto& faces = faces_[ref.feature];
  return ref.face < static_cast<int>(faces.size()) ? &faces[ref.face].surface : nullptr;
}

const Surface* FacesOfModel::find(const Ref& ref, const FacesOfModel& other) const {
  if (ref.feature >= static_cast<int>(faces_.size()) || other.find(ref) == nullptr) return nullptr;
  const auto &own = faces_[ref.feature], &others = other.faces_[ref.feature];
  const std::string& name = others[ref.face].name;
  const auto of_name = std::ranges::count(own, name, &SolidFace::name);
  if (of_name != std::ranges::count(others, name, &SolidFace::name)) return nullptr;
  auto before = std::count_if(others.begin(), others.begin() + ref.face,
                              [&](const SolidFace& face) { return face.name == name; });
  for (const SolidFace& face : own)
    if (face.name == name && before-- == 0) return &face.surface;
  return nullptr;
}

FeatureSurfaces::FeatureSurfaces(const BoundaryModel& boundary, const FeatureModel& model)
    : faces_(boundary.faces.size()),
      edges_(boundary.edges.size()),
      vertices_(boundary.vertices.size()),
      touching_edges_(boundary.edges.size()),
      touching_vertices_(boundary.vertices.size()) {
  const FacesOfModel faces(model);
  const Membership membership(model);
  // The CAD kernel takes faces this near to each other for one.
  const double near = 10 * tolerance::kOnSurface * boundary.bounds.diagonal();
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const BoundaryFace& face = boundary.faces[f];
    for (const FaceName& name : face.names) {
      const auto& of_feature = faces.of(name.feature);
      for (std::size_t k = 0; k < of_feature.size(); ++k)
        if (of_feature[k].name == name.face && lies_on(of_feature[k].surface, face.points, near))
          faces_[f].push_back({name.feature, static_cast<int>(k)});
    }
    unite(faces_[f]);
  }
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const BoundaryEdge& edge = boundary.edges[e];
    touching_edges_[e] =
        touched(edge.points, edge.points[edge.points.size() / 2], faces, membership, near);
    for (const int f : edge.faces)
      edges_[e].insert(edges_[e].end(), faces_[f].begin(), faces_[f].end());
    if (edge.rim && !edge.faces.empty()) {
      const Surface& own = boundary.faces[edge.faces.front()].surface;
      for (const Ref& ref : touching_edges_[e])
        if (!same_surface(*faces.find(ref), own, boundary.bounds, near)) edges_[e].push_back(ref);
    }
    unite(edges_[e]);
  }
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    const Vec3& p = boundary.vertices[v].position;
    touching_vertices_[v] = touched({&p, 1}, p, faces, membership, near);
    for (const int e : boundary.vertices[v].edges)
      vertices_[v].insert(vertices_[v].end(), edges_[e].begin(), edges_[e].end());
    unite(vertices_[v]);
  }
}

std::span<const Ref> FeatureSurfaces::at(const Support& support) const {
  switch (support.kind) {
    case Support::Kind::Vertex:
      return vertices_[support.entity];
    case Support::Kind::Edge:
      return edges_[support.entity];
    case Support::Kind::Face:
      return faces_[support.entity];
    case Support::Kind::Interior:
      break;
  }
  return {};
}

std::span<const Ref> FeatureSurfaces::touching(const Support& support) const {
  if (support.kind == Support::Kind::Vertex) return touching_vertices_[support.entity];
  if (support.kind == Support::Kind::Edge) return touching_edges_[support.entity];
  return {};
}

}  // namespace remeshd
