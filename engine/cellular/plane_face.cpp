#include "engine/cellular/plane_face.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/kernel/border_mesh.h"

namespace remeshd {
namespace {

using kernel::Border;
using kernel::Brep;
using kernel::BrepEdge;
using kernel::BrepFace;

constexpr double kAreaError = 0.05;  // of a face, by chords
constexpr double kArc = 0.1;         // rad, of a circle, between samples of an integral

/// Sums over a border about a point of the plane: the fans' areas, and these times their centroids.
struct Moments {
  double area = 0;
  Vec3 moment;

  /// A point of the border and the step along it there.
  void add(const Vec3& p, const Vec3& along, const Vec3& normal) {
    const double fan = 0.5 * dot(cross(p, along), normal);
    area += fan;
    moment += (2.0 / 3 * fan) * p;
  }
};

/// Three points of Gauss's rule for [-1, 1], weights for a length of 1.
constexpr std::array<std::array<double, 2>, 3> kRule{
    {{-0.7745966692414834, 5.0 / 18}, {0, 8.0 / 18}, {0.7745966692414834, 5.0 / 18}}};

void add_circle(const BrepEdge& edge, const Vec3& origin, double sign, const Vec3& normal,
                Moments& out) {
  const Vec3 start = edge.points.front() - edge.centre;
  const Vec3 u = normalised(start - dot(start, edge.axis) * edge.axis);
  const Vec3 v = cross(edge.axis, u);
  const double angle = edge.length / edge.radius;
  const int parts = std::max(1, static_cast<int>(std::ceil(angle / kArc)));
  const double step = angle / parts;
  for (int k = 0; k < parts; ++k)
    for (const auto& [x, weight] : kRule) {
      const double t = step * (k + 0.5 + 0.5 * x), c = std::cos(t), s = std::sin(t);
      out.add(edge.centre - origin + edge.radius * (c * u + s * v),
              sign * step * weight * edge.radius * (c * v - s * u), normal);
    }
}

/// Adds an edge, forward where `sign` is 1.
void add_edge(const BrepEdge& edge, const Vec3& origin, double sign, const Vec3& normal,
              Moments& out) {
  if (edge.kind == BrepEdge::Kind::Circle) return add_circle(edge, origin, sign, normal, out);
  if (edge.kind == BrepEdge::Kind::Other) {
    for (const auto& [p, along] : edge.samples) out.add(p - origin, sign * along, normal);
    return;
  }
  const Vec3 a = edge.points.front(), along = edge.points.back() - a;
  for (const auto& [x, weight] : kRule)
    out.add(a - origin + (0.5 + 0.5 * x) * along, sign * weight * along, normal);
}

Border flatten(const Brep& brep, const std::vector<PlaneEdge>& edges, const Transform& to_plane) {
  Border border;
  std::map<int, int> corner_of;
  const auto corner = [&](int node) {
    const auto [it, fresh] = corner_of.try_emplace(node, static_cast<int>(border.corners.size()));
    if (fresh) {
      const Vec3 p = to_plane.apply(brep.points[node]);
      border.corners.push_back({{p.x, p.y}, node});
    }
    return it->second;
  };
  for (const auto& [e, uses] : edges) {
    const std::vector<int>& chain = brep.edges[e].chain;
    for (int i = 0; i + 1 < static_cast<int>(chain.size()); ++i)
      border.segments.push_back({corner(chain[i]), corner(chain[i + 1]), e, i, uses});
  }
  return border;
}

}  // namespace

std::optional<std::vector<BrepFace>> plane_faces(const Brep& brep,
                                                 const std::vector<PlaneEdge>& edges,
                                                 const Surface& plane) {
  const Border border = flatten(brep, edges, rigid_inverse(plane.frame));
  const auto mesh = kernel::mesh_border(border, {});
  if (!mesh) return std::nullopt;
  const Vec3 n = plane.frame.rotate({0, 0, 1});

  std::vector<BrepFace> faces(mesh->regions);
  for (const auto& [corners, region] : mesh->triangles)
    faces[region].triangles.push_back({border.corners[corners[0]].node,
                                       border.corners[corners[1]].node,
                                       border.corners[corners[2]].node});
  std::vector<Moments> moments(faces.size());
  std::vector<Vec3> origins;
  for (const BrepFace& face : faces) origins.push_back(brep.points[face.triangles.front()[0]]);
  for (std::size_t k = 0; k < border.segments.size(); ++k) {
    const Border::Segment& s = border.segments[k];
    int sides = 0;
    for (const int side : {0, 1}) {
      const int region = mesh->sides[k][side];
      if (region < 0) continue;
      ++sides;
      if (s.index != 0) continue;
      faces[region].edges.push_back(s.edge);
      add_edge(brep.edges[s.edge], origins[region], side == 0 ? 1 : -1, n, moments[region]);
    }
    if (sides != s.uses) return std::nullopt;
  }
  for (std::size_t r = 0; r < faces.size(); ++r) {
    BrepFace& face = faces[r];
    double meshed = 0;
    for (const auto& [a, b, c] : face.triangles)
      meshed +=
          0.5 * dot(cross(brep.points[b] - brep.points[a], brep.points[c] - brep.points[a]), n);
    if (!(std::fabs(meshed - moments[r].area) <= kAreaError * meshed)) return std::nullopt;
    std::ranges::sort(face.edges);
    face.cells = {0, -1};
    face.area = moments[r].area;
    face.centroid = origins[r] + moments[r].moment / face.area;
    face.swept_volume = face.area * dot(plane.frame.apply({0, 0, 0}) - brep.reference, n) / 3;
  }
  return faces;
}

}  // namespace remeshd
