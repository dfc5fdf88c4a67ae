#include "engine/verify/verify.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <utility>

#include "engine/improve/boundary_rules.h"
#include "engine/improve/edge_chains.h"
#include "engine/mesh/quality.h"
#include "engine/verify/surface_facets.h"

namespace remeshd {
namespace {

constexpr std::uint32_t kKeptPerKind = 20;
/// A volume-length measure at which a tet counts as flat: its height is within rounding of zero
/// for any use of the mesh.
constexpr double kFlat = 1e-6;
/// Share of the model's diagonal within which a node stands on its support.
constexpr double kOnSupport = 1e-7;
std::string text(const Vec3& p) {
  std::array<char, 96> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "(%.6g, %.6g, %.6g)", p.x, p.y, p.z);
  return buffer.data();
}

class Checker {
 public:
  Checker(const TetMesh& mesh, std::span<const Support> supports, const BoundaryModel& boundary,
          const Run& run)
      : mesh_(mesh),
        supports_(supports),
        boundary_(boundary),
        faces_(boundary, supports),
        tolerance_(kOnSupport * boundary.bounds.diagonal()),
        poll_(run) {}

  Verification check(double exact_volume, double volume_tolerance) {
    check_tets();
    check_surface();
    check_nodes();
    check_edges();
    check_faces();
    const double error = std::fabs(result_.volume + result_.chord_volume - exact_volume);
    if (!(error <= volume_tolerance * exact_volume))
      fail(MeshFailure::Volume, -1, 0.5 * (boundary_.bounds.lo + boundary_.bounds.hi),
           "the volume is " + std::to_string(result_.volume) + ", chords apart " +
               std::to_string(result_.volume + result_.chord_volume) + ", the model's " +
               std::to_string(exact_volume));
    result_.valid = result_.failures.empty();
    result_.surface = std::move(surface_);
    return std::move(result_);
  }

 private:
  using Edge = std::pair<std::int32_t, std::int32_t>;

  void fail(MeshFailure kind, std::int32_t entity, const Vec3& place, std::string_view what) {
    if (result_.counts[static_cast<std::size_t>(kind)]++ >= kKeptPerKind) return;
    result_.failures.push_back({kind, entity, place, std::string(what) + " at " + text(place)});
  }
  [[nodiscard]] Vec3 centroid(std::int32_t t) const {
    Vec3 c;
    for (const std::int32_t n : mesh_.tets[t]) c += 0.25 * mesh_.nodes[n];
    return c;
  }

  void check_tets() {
    used_.assign(mesh_.nodes.size(), 0);
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
      poll_();
      const Tet& tet = mesh_.tets[t];
      for (const std::int32_t n : tet) used_[n] = 1;
      const Vec3& a = mesh_.nodes[tet[0]];
      const Vec3& b = mesh_.nodes[tet[1]];
      const Vec3& c = mesh_.nodes[tet[2]];
      const Vec3& d = mesh_.nodes[tet[3]];
      result_.volume += tet_volume(a, b, c, d);
      const double quality = volume_length(a, b, c, d);
      const auto index = static_cast<std::int32_t>(t);
      if (!(quality > kFlat))
        fail(MeshFailure::BadTet, index, centroid(index),
             quality < -kFlat ? "an inverted tet" : "a flat tet");
    }
  }

  void check_surface() {
    FacetMatch match = match_facets(mesh_.tets, mesh_.nodes.size(), poll_);
    for (const std::int32_t t : match.clashes)
      fail(MeshFailure::BadFacet, t, centroid(t), "a tet that overlaps another across a facet");
    surface_ = std::move(match.surface);
    result_.boundary_facets = static_cast<std::uint32_t>(surface_.size());

    edges_.reserve(3 * surface_.size());
    for (const SurfaceFacet& facet : surface_)
      for (int i = 0; i < 3; ++i) edges_.emplace_back(facet.nodes[i], facet.nodes[(i + 1) % 3]);
    std::sort(edges_.begin(), edges_.end());
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      poll_();
      const Edge& edge = edges_[i];
      const bool twice = i + 1 < edges_.size() && edges_[i + 1] == edge;
      const bool matched =
          std::binary_search(edges_.begin(), edges_.end(), Edge{edge.second, edge.first});
      if (twice || !matched)
        fail(MeshFailure::OpenBoundary, edge.first,
             0.5 * (mesh_.nodes[edge.first] + mesh_.nodes[edge.second]),
             "a boundary edge that is not in two boundary facets");
    }
    check_fans();
  }

  /// The facets round each boundary node must turn it once.
  void check_fans() {
    on_surface_.assign(mesh_.nodes.size(), 0);
    std::vector<std::uint32_t> begin(mesh_.nodes.size() + 1, 0);
    for (const SurfaceFacet& facet : surface_)
      for (const std::int32_t n : facet.nodes) ++begin[n + 1];
    for (std::size_t n = 1; n < begin.size(); ++n) begin[n] += begin[n - 1];
    std::vector<Edge> spokes(3 * surface_.size());
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (const SurfaceFacet& facet : surface_)
      for (int i = 0; i < 3; ++i)
        spokes[next[facet.nodes[i]]++] = {facet.nodes[(i + 1) % 3], facet.nodes[(i + 2) % 3]};
    for (std::size_t n = 0; n < mesh_.nodes.size(); ++n) {
      poll_();
      const std::span<const Edge> fan(spokes.data() + begin[n], begin[n + 1] - begin[n]);
      if (fan.empty()) continue;
      on_surface_[n] = 1;
      std::size_t turned = 1;
      std::int32_t at = fan[0].second;
      while (at != fan[0].first && turned < fan.size()) {
        const auto* const it = std::find_if(fan.data(), fan.data() + fan.size(),
                                            [&](const Edge& e) { return e.first == at; });
        if (it == fan.data() + fan.size()) break;
        at = it->second;
        ++turned;
      }
      if (at != fan[0].first || turned != fan.size())
        fail(MeshFailure::PinchedNode, static_cast<std::int32_t>(n), mesh_.nodes[n],
             "a node whose boundary facets are not one fan");
    }
  }

  void check_nodes() {
    std::vector<std::int32_t> vertex_node(boundary_.vertices.size(), -1);
    for (std::size_t n = 0; n < mesh_.nodes.size(); ++n) {
      poll_();
      const auto node = static_cast<std::int32_t>(n);
      const Vec3& p = mesh_.nodes[n];
      if (used_[n] == 0) {
        fail(MeshFailure::OrphanNode, node, p, "a node in no tet");
        continue;
      }
      const Support& support = supports_[n];
      if (support.kind == Support::Kind::Interior) continue;
      if (!(distance(project(boundary_, support, p), p) <= tolerance_))
        fail(MeshFailure::NodeOffSupport, node, p, "a node away from where it should stand");
      if (support.kind == Support::Kind::Vertex && on_surface_[n] != 0)
        vertex_node[support.entity] = node;
    }
    for (std::size_t v = 0; v < vertex_node.size(); ++v)
      if (vertex_node[v] < 0)
        fail(MeshFailure::MissingVertex, static_cast<std::int32_t>(v),
             boundary_.vertices[v].position, "a model vertex without a boundary node");
  }

  void check_edges() {
    chains_ = edge_chains(boundary_, supports_, mesh_.nodes);
    for (std::size_t e = 0; e < chains_.size(); ++e) {
      const BoundaryEdge& edge = boundary_.edges[e];
      const auto& chain = chains_[e];
      const auto index = static_cast<std::int32_t>(e);
      // A closed chain comes back to its first node over two others at least; an open one whose
      // vertices are missing fails by its length or by the vertices.
      if (chain.size() < (edge.closed() ? 4U : 2U)) {
        fail(MeshFailure::BrokenEdge, index, edge.points[edge.points.size() / 2],
             "a model edge with too few nodes");
        continue;
      }
      for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        if (!std::binary_search(edges_.begin(), edges_.end(), Edge{chain[i], chain[i + 1]}))
          fail(MeshFailure::BrokenEdge, index,
               0.5 * (mesh_.nodes[chain[i]] + mesh_.nodes[chain[i + 1]]),
               "a model edge whose chain of boundary edges is broken");
    }
  }

  void check_faces() {
    std::vector<double> area(boundary_.faces.size(), 0);
    std::vector<double> slack(boundary_.faces.size(), 0);
    for (const SurfaceFacet& facet : surface_) {
      poll_();
      const Vec3& a = mesh_.nodes[facet.nodes[0]];
      const Vec3& b = mesh_.nodes[facet.nodes[1]];
      const Vec3& c = mesh_.nodes[facet.nodes[2]];
      const Vec3 centre = (a + b + c) / 3.0;
      const Vec3 normal = cross(b - a, c - a);
      const double facet_area = 0.5 * norm(normal);
      result_.boundary_area += facet_area;
      const int face = faces_.face_of(facet.nodes, mesh_.nodes);
      if (face < 0) {
        fail(MeshFailure::StrayFacet, facet.tet, centre, "a boundary facet on no model face");
        continue;
      }
      if (dot(normal, faces_.outward(face, centre)) <= 0)
        fail(MeshFailure::StrayFacet, facet.tet, centre,
             "a boundary facet that is turned over on its face");
      area[face] += facet_area;
      if (boundary_.faces[face].surface.kind == Surface::Kind::Plane) continue;
      // Exact for a surface that is quadratic over the facet (mid-edge rule).
      for (const Vec3& middle : {0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)})
        result_.chord_volume -= facet_area / 3 * faces_.height(face, middle);
      const double radius = radius_of_curvature(boundary_.faces[face].surface, centre);
      const double longest2 = std::max({norm2(b - a), norm2(c - b), norm2(a - c)});
      slack[face] += facet_area * std::min(1.0, 0.25 * longest2 / (radius * radius));
    }
    // On a face beside a curved edge the lens between chord and curve is missing or too much.
    for (std::size_t e = 0; e < chains_.size(); ++e) {
      if (boundary_.edges[e].curve.kind == Curve::Kind::Line) continue;
      for (std::size_t i = 0; i + 1 < chains_[e].size(); ++i) {
        const Vec3& a = mesh_.nodes[chains_[e][i]];
        const Vec3& b = mesh_.nodes[chains_[e][i + 1]];
        const Vec3 middle = 0.5 * (a + b);
        const double sagitta = distance(middle, project(boundary_, boundary_.edges[e], middle));
        for (const int face : boundary_.edges[e].faces) slack[face] += sagitta * distance(a, b);
      }
    }
    for (std::size_t f = 0; f < area.size(); ++f) {
      const double exact = boundary_.faces[f].area;
      if (std::fabs(area[f] - exact) <= slack[f] + 1e-6 * exact) continue;
      const BoundaryFace& face = boundary_.faces[f];
      fail(MeshFailure::FaceArea, static_cast<std::int32_t>(f),
           face.points.empty() ? face.surface.frame.apply({}) : face.points.front(),
           "a model face of area " + std::to_string(exact) + " with facets of area " +
               std::to_string(area[f]));
    }
  }

  /// Smallest radius of curvature at p, infinite on a plane.
  static double radius_of_curvature(const Surface& surface, const Vec3& p) {
    switch (surface.kind) {
      case Surface::Kind::Plane:
        break;
      case Surface::Kind::Cylinder:
      case Surface::Kind::Sphere:
        return surface.r1;
      case Surface::Kind::Torus:
        return surface.r2;
      case Surface::Kind::Cone: {
        const Transform& frame = surface.frame;
        const Vec3 axis{frame.m[2], frame.m[6], frame.m[10]};
        const Vec3 from = p - Vec3{frame.m[3], frame.m[7], frame.m[11]};
        return norm(from - dot(from, axis) * axis);
      }
    }
    return HUGE_VAL;
  }

  const TetMesh& mesh_;
  std::span<const Support> supports_;
  const BoundaryModel& boundary_;
  FacetFaces faces_;
  double tolerance_;
  Polling poll_;
  Verification result_;
  std::vector<std::uint8_t> used_, on_surface_;
  std::vector<SurfaceFacet> surface_;
  std::vector<Edge> edges_;  ///< of the boundary facets, in their turning direction, sorted
  std::vector<std::vector<std::int32_t>> chains_;
};

}  // namespace

Verification verify(const TetMesh& mesh, std::span<const Support> supports,
                    const BoundaryModel& boundary, double exact_volume, const Run& run,
                    double volume_tolerance) {
  return Checker(mesh, supports, boundary, run).check(exact_volume, volume_tolerance);
}

}  // namespace remeshd
