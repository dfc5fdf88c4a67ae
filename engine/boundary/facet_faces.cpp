#include "engine/boundary/facet_faces.h"

#include <algorithm>
#include <numeric>

#include "engine/base/union_find.h"
#include "engine/cellular/boundary_model/face_distance.h"
#include "engine/mesh/grouping.h"

namespace remeshd {
namespace {

/// Two faces compete for a facet by the cosines between their normals and the facet's. Where the
/// cosines differ by less than this, as of faces that cross at less than 18 degrees, they do not
/// decide.
constexpr double kSameFit = 0.05;

/// Each corner of a facet is moved by this share of the way to its centroid before it is tested
/// whether the axis passes through the facet: a corner at an apex, which is on the axis, does not
/// count.
constexpr double kWithin = 0.01;
/// x the sum of the squared coordinates of two corners: where twice the area of their triangle with
/// the origin is less, it counts as 0, because of rounding.
constexpr double kRounding = 1e-9;

using Point2 = std::array<double, 2>;

/// Whether the origin is in a triangle, its sides included. Also true where all three corners lie
/// on one line through the origin.
bool has_origin(const std::array<Point2, 3>& corners) {
  int left = 0, right = 0;
  for (int i = 0; i < 3; ++i) {
    const auto& [a, b] = corners[i];
    const auto& [c, d] = corners[(i + 1) % 3];
    const double area = a * d - b * c, none = kRounding * (a * a + b * b + c * c + d * d);
    left += area > -none ? 1 : 0;
    right += area < none ? 1 : 0;
  }
  return left == 3 || right == 3;
}

}  // namespace

FacesOf::FacesOf(const BoundaryModel& boundary)
    : face_(boundary.faces.size()),
      edge_(boundary.edges.size()),
      vertex_(boundary.vertices.size()) {
  std::iota(face_.begin(), face_.end(), 0);
  for (const BoundaryFace& face : boundary.faces)
    plane_.push_back(face.surface.kind == Surface::Kind::Plane);
  for (std::size_t e = 0; e < edge_.size(); ++e) edge_[e] = boundary.edges[e].faces;
  for (std::size_t v = 0; v < vertex_.size(); ++v) {
    for (const int e : boundary.vertices[v].edges)
      vertex_[v].insert(vertex_[v].end(), edge_[e].begin(), edge_[e].end());
    if (boundary.vertices[v].edges.empty())  // the apex of a cone
      for (std::size_t f = 0; f < face_.size(); ++f) {
        const auto index = static_cast<std::int32_t>(f);
        if (incident(boundary, {Support::Kind::Vertex, static_cast<std::int32_t>(v)},
                     {Support::Kind::Face, index}))
          vertex_[v].push_back(index);
      }
    sort_unique(vertex_[v]);
  }
}

FacesOf FacesOf::across_rims(const BoundaryModel& boundary) {
  FacesOf out(boundary);
  UnionFind joined(boundary.faces.size());
  for (const BoundaryEdge& edge : boundary.edges)
    if (edge.rim) joined.join(edge.faces.front(), edge.faces.back());
  for (int& face : out.face_) face = joined.find(face);
  for (auto* lists : {&out.edge_, &out.vertex_})
    for (std::vector<int>& faces : *lists) {
      for (int& face : faces) face = joined.find(face);
      sort_unique(faces);
    }
  return out;
}

std::span<const int> FacesOf::operator()(const Support& support) const {
  switch (support.kind) {
    case Support::Kind::Face:
      return {&face_[support.entity], 1};
    case Support::Kind::Edge:
      return edge_[support.entity];
    case Support::Kind::Vertex:
      return vertex_[support.entity];
    case Support::Kind::Interior:
      break;
  }
  return {};
}

int FacesOf::common(std::span<const Support> supports) const {
  int first = -1;
  for (const int face : (*this)(supports[0])) {
    const bool shared = std::all_of(supports.begin() + 1, supports.end(), [&](const Support& s) {
      const auto faces = (*this)(s);
      return std::binary_search(faces.begin(), faces.end(), face);
    });
    if (!shared) continue;
    if (plane_[face]) return face;
    if (first < 0) first = face;
  }
  return first;
}

FacetFaces::FacetFaces(const BoundaryModel& boundary, std::span<const Support> supports)
    : boundary_(boundary), supports_(supports), faces_(boundary) {}

int FacetFaces::face_of(const Triangle& facet, const Vec3& a, const Vec3& b, const Vec3& c) const {
  const auto at_b = faces_of(facet[1]);
  const auto at_c = faces_of(facet[2]);
  int best = -1;
  double best_fit = 0;
  Vec3 centroid;
  Vec3 normal;
  for (const int f : faces_of(facet[0])) {
    if (std::find(at_b.begin(), at_b.end(), f) == at_b.end()) continue;
    if (std::find(at_c.begin(), at_c.end(), f) == at_c.end()) continue;
    if (best < 0) {
      best = f;
      continue;
    }
    if (norm2(normal) == 0) {
      centroid = (a + b + c) / 3.0;
      normal = cross(b - a, c - a);
      best_fit = dot(normal, outward(best, centroid));
    }
    const double fit = dot(normal, outward(f, centroid));
    const bool better = std::fabs(fit - best_fit) > kSameFit * norm(normal)
                            ? fit > best_fit
                            : face_distance2(f, centroid) < face_distance2(best, centroid);
    if (!better) continue;
    best_fit = fit;
    best = f;
  }
  return best;
}

double FacetFaces::face_distance2(int face, const Vec3& p) const {
  const BoundaryFace& f = boundary_.faces[face];
  return remeshd::face_distance2(f, project(f.surface, p));
}

bool FacetFaces::lies_across(int face, const std::array<Vec3, 3>& corners) const {
  const Surface& surface = boundary_.faces[face].surface;
  if (surface.kind == Surface::Kind::Plane || surface.kind == Surface::Kind::Sphere) return false;
  const Transform into = rigid_inverse(surface.frame);
  const Vec3 centroid = (corners[0] + corners[1] + corners[2]) / 3.0;
  std::array<Point2, 3> round_axis{}, round_tube{};
  for (int i = 0; i < 3; ++i) {
    const Vec3 q = into.apply(corners[i] + kWithin * (centroid - corners[i]));
    round_axis[i] = {q.x, q.y};
    round_tube[i] = {std::sqrt(q.x * q.x + q.y * q.y) - surface.r1, q.z};
  }
  return has_origin(round_axis) || (surface.kind == Surface::Kind::Torus && has_origin(round_tube));
}

bool FacetFaces::lies_along(int face, const std::array<Vec3, 3>& corners) const {
  const auto& [a, b, c] = corners;
  return lies_along(face, corners,
                    std::max({deviation(face, (a + b + c) / 3.0), deviation(face, 0.5 * (a + b)),
                              deviation(face, 0.5 * (b + c)), deviation(face, 0.5 * (c + a))}));
}

bool FacetFaces::lies_along(int face, const std::array<Vec3, 3>& corners, double off) const {
  const auto& [a, b, c] = corners;
  const double longest2 = std::max({norm2(b - a), norm2(c - b), norm2(a - c)});
  return off * off <= kChordShare * kChordShare * longest2 && !lies_across(face, corners);
}

Vec3 FacetFaces::outward(int face, const Vec3& p) const {
  return outward_normal(boundary_.faces[face], p);
}

double FacetFaces::height(int face, const Vec3& p) const {
  const BoundaryFace& f = boundary_.faces[face];
  const double d = signed_distance(f.surface, p);
  return f.reversed ? -d : d;
}

}  // namespace remeshd
