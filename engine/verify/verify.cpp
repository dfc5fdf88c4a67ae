#include "engine/verify/verify.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

#include "engine/base/parallel.h"
#include "engine/base/tolerance.h"
#include "engine/boundary/edge_chains.h"
#include "engine/boundary/facet_faces.h"
#include "engine/mesh/grouping.h"
#include "engine/mesh/quality.h"
#include "engine/verify/surface_facets.h"

namespace remeshd {
namespace {

/// A volume-length measure at which a tet counts as flat: its height is within rounding of zero
/// for any use of the mesh.
constexpr double kFlat = 1e-6;

std::string text(const Vec3& p) {
  std::array<char, 96> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "(%.6g, %.6g, %.6g)", p.x, p.y, p.z);
  return buffer.data();
}

class Checker {
 public:
  Checker(const PagedMesh& mesh, const CowVector<Support>& supports, const BoundaryModel& boundary,
          const Run& run, const VerifyOptions& options)
      : mesh_(mesh),
        supports_(supports.flat()),
        boundary_(boundary),
        options_(options),
        faces_(boundary, supports_),
        tolerance_(tolerance::kOnSurface * boundary.bounds.diagonal()),
        run_(run),
        poll_(run) {
    if (options.parent && !options.parent->mesh.tets.empty())
      inherited_ = correspond(mesh, *options.parent, poll_);
  }

  Verification check(double exact_volume) {
    check_tets();
    check_surface();
    check_nodes();
    check_edges();
    check_faces();
    check_volume(exact_volume);
    result_.valid = result_.failures.empty();
    result_.surface = std::move(surface_);
    if (inherited_) {
      result_.changed_tets = std::move(inherited_->unchanged.changed_tets);
    } else {
      result_.changed_tets.resize(mesh_.tets.size());
      std::iota(result_.changed_tets.begin(), result_.changed_tets.end(), 0);
    }
    return std::move(result_);
  }

 private:
  /// A boundary facet seen from one of its nodes: the other two in its turning direction.
  using Spoke = std::pair<std::int32_t, std::int32_t>;

  void fail(MeshFailure kind, std::int32_t entity, const Vec3& place, std::string_view what) {
    if (result_.counts[static_cast<std::size_t>(kind)]++ >= options_.most_failures) return;
    result_.failures.push_back({kind, entity, place, std::string(what) + " at " + text(place)});
  }
  void fail_tet(MeshFailure kind, std::int32_t t, std::string_view what) {
    fail(kind, t, centroid(mesh_.nodes, mesh_.tets[t]), what);
  }

  void check_tets() {
    used_.assign(mesh_.nodes.size(), 0);
    const auto use = [&](std::size_t t) {
      for (const std::int32_t n : mesh_.tets[t]) used_[n] = 1;
    };
    if (!inherited_) {
      for (std::size_t t = 0; t < mesh_.tets.size(); ++t) use(t);
      prove(mesh_.tets.size(), [](std::size_t k) { return static_cast<std::int32_t>(k); });
      return;
    }
    // An untouched node of the parent still has its tets.
    for (const std::int32_t n : inherited_->heir)
      if (n >= 0 && inherited_->touched[n] == 0) used_[n] = 1;
    for (const std::int32_t t : inherited_->near) use(t);
    prove(inherited_->changed.size(), [&](std::size_t k) { return inherited_->changed[k]; });
    result_.tets_inherited = static_cast<std::uint32_t>(mesh_.tets.size()) - result_.tets_proved;
    const VerifiedParent& parent = *options_.parent;
    result_.volume += parent.volume;
    for (const std::int32_t o : inherited_->gone)
      result_.volume -= tet_volume(parent.mesh.nodes, parent.mesh.tets[o]);
  }

  /// Checks the tets tet_of(0), ..., tet_of(count - 1) and adds their volumes to the mesh's.
  template <class TetOf>
  void prove(std::size_t count, const TetOf& tet_of) {
    struct Bad {
      std::int32_t tet;
      double quality;
      bool outside;
    };
    std::vector<double> volumes((count + kFairBlock - 1) / kFairBlock, 0);
    const auto all_bad = collect_in_blocks<Bad>(
        count, kFairBlock, run_, [&](std::size_t begin, std::size_t end, std::vector<Bad>& found) {
          run_.poll();
          for (std::size_t k = begin; k < end; ++k) {
            const std::int32_t t = tet_of(k);
            const Tet& tet = mesh_.tets[t];
            volumes[begin / kFairBlock] += tet_volume(mesh_.nodes, tet);
            const double quality = volume_length(mesh_.nodes, tet);
            const bool outside = options_.material && !in_material(tet);
            if (outside || !(quality > kFlat)) found.push_back({t, quality, outside});
          }
        });
    result_.tets_proved += static_cast<std::uint32_t>(count);
    for (const double volume : volumes) result_.volume += volume;
    for (const Bad& bad : all_bad) {
      if (!(bad.quality > kFlat))
        fail_tet(MeshFailure::BadTet, bad.tet,
                 bad.quality < -kFlat ? "an inverted tet" : "a flat tet");
      if (bad.outside) fail_tet(MeshFailure::OutsideTet, bad.tet, "a tet outside of the material");
    }
  }

  /// Whether the tet lies in the material: by its centroid or, as that may lie between a chord and
  /// a concave face, by points nearer to one of its corners. A tet with all nodes on one face may
  /// lie there as a whole; then it may be as far off that face as a chord may.
  [[nodiscard]] bool in_material(const Tet& tet) const {
    const Vec3 c = centroid(mesh_.nodes, tet);
    if (options_.material(c)) return true;
    for (const double share : {0.5, 0.9})
      for (const std::int32_t n : tet)
        if (options_.material((1 - share) * c + share * mesh_.nodes[n])) return true;
    double longest = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j)
        longest = std::max(longest, distance(mesh_.nodes[tet[i]], mesh_.nodes[tet[j]]));
    const auto at_first = faces_.faces_of(tet[0]);
    return std::any_of(at_first.begin(), at_first.end(), [&](int face) {
      return std::all_of(tet.begin() + 1, tet.end(),
                         [&](std::int32_t n) {
                           const auto at = faces_.faces_of(n);
                           return std::find(at.begin(), at.end(), face) != at.end();
                         }) &&
             faces_.deviation(face, c) <= kChordShare * longest;
    });
  }

  void check_surface() {
    const std::size_t nodes = mesh_.nodes.size();
    FacetMatch match = inherited_
                           ? match_facets(mesh_.tets, nodes, *options_.parent, *inherited_, poll_)
                           : match_facets(mesh_.tets, nodes, poll_);
    for (const std::int32_t t : match.clashes)
      fail_tet(MeshFailure::BadFacet, t, "a tet that overlaps another across a facet");
    for (const std::int32_t t : repeated_tets(mesh_.tets, nodes, match.clashes))
      fail_tet(MeshFailure::RepeatedTet, t, "a tet that is there twice");
    surface_ = std::move(match.surface);
    result_.boundary_facets = static_cast<std::uint32_t>(surface_.size());

    fans_ = grouped<Spoke>(nodes, [&](const auto& visit) {
      for (const SurfaceFacet& facet : surface_) {
        const auto& [a, b, c] = facet.nodes;
        visit(a, Spoke{b, c});
        visit(b, Spoke{c, a});
        visit(c, Spoke{a, b});
      }
    });
    for (std::size_t n = 0; n < nodes; ++n) {
      poll_();
      if (inherited_ && inherited_->touched[n] == 0) continue;
      const auto node = static_cast<std::int32_t>(n);
      check_boundary_edges(node);
      check_fan(node);
    }
  }

  /// The boundary facets at a node.
  [[nodiscard]] std::span<const Spoke> fan(std::int32_t n) const { return fans_[n]; }
  /// Whether a boundary facet has the edge from a to b in its turning direction.
  [[nodiscard]] bool boundary_edge(std::int32_t a, std::int32_t b) const {
    const auto at = fan(a);
    return std::ranges::find(at, b, &Spoke::first) != at.end();
  }

  /// Every edge of the boundary facets at a node has one facet on each side: it leaves the node
  /// once and comes back.
  void check_boundary_edges(std::int32_t n) {
    const auto at = fan(n);
    for (std::size_t i = 0; i < at.size(); ++i) {
      const std::int32_t b = at[i].first;
      const bool twice = std::any_of(at.begin() + static_cast<std::ptrdiff_t>(i) + 1, at.end(),
                                     [&](const Spoke& s) { return s.first == b; });
      const bool back = std::ranges::find(at, b, &Spoke::second) != at.end();
      if (twice || !back)
        fail(MeshFailure::NonManifoldEdge, n, 0.5 * (mesh_.nodes[n] + mesh_.nodes[b]),
             "a boundary edge that is not in two boundary facets");
    }
  }

  /// The boundary facets at a node form one closed fan.
  void check_fan(std::int32_t n) {
    const auto at = fan(n);
    if (at.empty()) return;
    std::size_t turned = 1;
    std::int32_t edge = at[0].second;
    while (edge != at[0].first && turned < at.size()) {
      const auto it = std::ranges::find(at, edge, &Spoke::first);
      if (it == at.end()) break;
      edge = it->second;
      ++turned;
    }
    if (edge != at[0].first || turned != at.size())
      fail(MeshFailure::NonManifoldVertex, n, mesh_.nodes[n],
           "a node whose boundary facets are not one fan");
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
      if (support.kind == Support::Kind::Vertex && !fan(node).empty())
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
        fail(MeshFailure::MissingSegment, index, edge.points[edge.points.size() / 2],
             "a model edge with too few nodes");
        continue;
      }
      for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        if (!boundary_edge(chain[i].node, chain[i + 1].node))
          fail(MeshFailure::MissingSegment, index,
               0.5 * (mesh_.nodes[chain[i].node] + mesh_.nodes[chain[i + 1].node]),
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
      const int face = faces_.face_of(facet.nodes, a, b, c);
      if (face < 0) {
        fail(MeshFailure::NonconformingFacet, facet.tet, centre,
             "a boundary facet on no model face");
        continue;
      }
      if (dot(normal, faces_.outward(face, centre)) <= 0)
        fail(MeshFailure::NonconformingFacet, facet.tet, centre,
             "a boundary facet that is turned over on its face");
      area[face] += facet_area;
      if (boundary_.faces[face].surface.kind == Surface::Kind::Plane) continue;
      double off = faces_.deviation(face, centre);
      for (const Vec3& middle : {0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)}) {
        const double height = faces_.height(face, middle);
        off = std::max(off, std::fabs(height));
        // Exact for a surface that is quadratic over the facet (mid-edge rule).
        result_.chord_volume -= facet_area / 3 * height;
      }
      result_.chord_error = std::max(result_.chord_error, off);
      const double radius = radius_of_curvature(boundary_.faces[face].surface, centre);
      const double longest2 = std::max({norm2(b - a), norm2(c - b), norm2(a - c)});
      if (!faces_.lies_along(face, {a, b, c}, off))
        fail(MeshFailure::FacetOffFace, facet.tet, centre,
             "a boundary facet " + std::to_string(off) + " off its face");
      slack[face] += facet_area * std::min(1.0, 0.25 * longest2 / (radius * radius));
    }
    // Beside a curved edge the facets of a face have too little or too much area: that between the
    // edge and its chords.
    for (std::size_t e = 0; e < chains_.size(); ++e) {
      if (boundary_.edges[e].curve.kind == Curve::Kind::Line) continue;
      for (std::size_t i = 0; i + 1 < chains_[e].size(); ++i) {
        const Vec3& a = mesh_.nodes[chains_[e][i].node];
        const Vec3& b = mesh_.nodes[chains_[e][i + 1].node];
        const Vec3 middle = 0.5 * (a + b);
        const double sagitta = distance(middle, project(boundary_, boundary_.edges[e], middle));
        result_.chord_error = std::max(result_.chord_error, sagitta);
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

  void check_volume(double exact) {
    const double whole = result_.volume + result_.chord_volume;
    const double error = std::fabs(whole - exact);
    result_.volume_error = error / exact;
    if (!(error <= options_.volume_tolerance * exact))
      fail(MeshFailure::Volume, -1, 0.5 * (boundary_.bounds.lo + boundary_.bounds.hi),
           "the volume is " + std::to_string(result_.volume) + ", chords apart " +
               std::to_string(whole) + ", the model's " + std::to_string(exact));
  }

  const PagedMesh& mesh_;
  const std::vector<Support> supports_;
  const BoundaryModel& boundary_;
  const VerifyOptions& options_;
  FacetFaces faces_;
  double tolerance_;
  const Run& run_;
  Polling poll_;
  std::optional<TetCorrespondence> inherited_;
  Verification result_;
  std::vector<std::uint8_t> used_;
  std::vector<SurfaceFacet> surface_;
  Grouping<Spoke> fans_;  ///< by node
  std::vector<std::vector<NodeOnEdge>> chains_;
};

}  // namespace

Verification verify(const PagedMesh& mesh, const CowVector<Support>& supports,
                    const BoundaryModel& boundary, double exact_volume, const Run& run,
                    const VerifyOptions& options) {
  return Checker(mesh, supports, boundary, run, options).check(exact_volume);
}

Verification verify(const TetMesh& mesh, std::span<const Support> supports,
                    const BoundaryModel& boundary, double exact_volume, const Run& run,
                    const VerifyOptions& options) {
  return verify(paged(mesh), CowVector(supports), boundary, exact_volume, run, options);
}

std::string to_text(const Verification& v) {
  std::string out = v.valid ? "valid" : "not valid";
  out += "\n" + std::to_string(v.tets_proved) + " tets proved, " +
         std::to_string(v.tets_inherited) + " inherited, " + std::to_string(v.boundary_facets) +
         " boundary facets\n";
  for (const MeshDefect& defect : v.failures) out += defect.what + "\n";
  return out;
}

}  // namespace remeshd
