#include "engine/boundary/cover/cover_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "engine/boundary/cover/flat_map.h"
#include "engine/boundary/cover/open_borders.h"
#include "engine/boundary/edge_chains.h"
#include "engine/boundary/surface_crossings.h"
#include "engine/cellular/boundary_model/face_distance.h"
#include "engine/kernel/border_mesh.h"
#include "engine/mesh/grouping.h"

namespace remeshd {
namespace {

struct CoverLimits {
  int rounds = 12;            ///< of adding nodes
  double film = 0.2;          ///< x edge length: a thinner layer between two faces is a film
  double closest = 0.3;       ///< x edge length: of an inner node from the border, at least
  double shortest = 1e-3;     ///< x edge length: no shorter side is halved
  double long_share = 0.7;    ///< of a facet's longest side: longer sides are halved with it
  double least_cosine = 0.7;  ///< between a facet and its face
};
constexpr CoverLimits kCoverLimits;

double segment_distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  return std::sqrt(nearest_on_polyline(std::array{a, b}, p).distance2);
}

class Cover {
 public:
  Cover(OpenSurface& open, const BoundaryModel& boundary, const SizeField& sizes, const Run& run)
      : open_(open),
        boundary_(boundary),
        sizes_(sizes),
        run_(run),
        kept_(open.mesh.facets.size()),
        sides_(open.mesh, open.walls, boundary, kCoverLimits.shortest * sizes.base()) {
    const SurfaceMesh& mesh = open_.mesh;
    for (const std::int32_t n : open_.loose)
      if (mesh.supports[n].kind == Support::Kind::Face)
        loose_[mesh.supports[n].entity].push_back(n);
  }

  std::string cover() {
    for (int round = 0; round < kCoverLimits.rounds; ++round) {
      run_.poll();
      open_.mesh.facets.resize(kept_);
      changed_ = false;
      borders_ = sides_.find();
      for (const auto& [face, border] : borders_) {
        std::string failed = cover_face(face, border);
        if (!failed.empty()) return failed;
      }
      if (changed_) continue;
      if (!refine_crossings() && !refine_bent() && !refine_asked()) return stuck_;
      if (!stuck_.empty()) return stuck_;
    }
    return "the cover of the open boundary still changed after " +
           std::to_string(kCoverLimits.rounds) + " rounds";
  }

 private:
  [[nodiscard]] kernel::Border flat_border(const std::vector<BorderSide>& border,
                                           const FlatMap& map) const {
    kernel::Border flat;
    std::map<std::int32_t, int> corner_of;
    const auto corner = [&](std::int32_t n) {
      const auto [it, fresh] = corner_of.try_emplace(n, static_cast<int>(flat.corners.size()));
      if (fresh) flat.corners.push_back({map(open_.mesh.nodes[n]), n});
      return it->second;
    };
    for (const BorderSide& s : border)
      flat.segments.push_back({corner(s.side.first), corner(s.side.second), s.edge, -1, s.uses});
    return flat;
  }

  /// Whether a point is so near to the border of the open part that a node there would crowd it.
  [[nodiscard]] bool crowds_border(const Vec3& p, const std::vector<BorderSide>& border) const {
    const auto& nodes = open_.mesh.nodes;
    const double closest = kCoverLimits.closest * sizes_(p);
    return std::ranges::any_of(border, [&](const BorderSide& s) {
      return segment_distance(p, nodes[s.side.first], nodes[s.side.second]) < closest;
    });
  }

  /// The place on a face for the counterpart of a node on the other side of a film; nothing where
  /// there is no film between the node and the face, or the node stands on that face.
  [[nodiscard]] std::optional<Vec3> across_film(std::int32_t node, std::int32_t face) const {
    const Vec3& p = open_.mesh.nodes[node];
    const Vec3 q = project(boundary_.faces[face].surface, p);
    const double film = kCoverLimits.film * sizes_(p);
    if (norm2(p - q) > film * film) return {};
    if (incident(boundary_, open_.mesh.supports[node], {Support::Kind::Face, face})) return {};
    return q;
  }

  /// The nodes for the inside of a face. First the counterparts of nodes on the other side of a
  /// film: of nodes on the borders of other faces, and of all nodes of facets made before on other
  /// faces. Away from these, the loose nodes that do not crowd the border. Last the nodes that
  /// `refine` has added. Where both sides of a film have the same nodes, and so mostly the same
  /// triangles, TetGen needs few points of its own between them.
  std::vector<std::int32_t> inner_nodes(std::int32_t face, const std::vector<BorderSide>& border) {
    std::vector<std::int32_t> nodes;
    for (const std::int32_t other : film_nodes(face)) {
      const std::optional<Vec3> q = across_film(other, face);
      if (!q || crowds_border(*q, border) || is_near(*q, nodes)) continue;
      const auto [it, fresh] = counterparts_.try_emplace({face, other}, -1);
      if (fresh) it->second = sides_.add_node({Support::Kind::Face, face}, *q);
      nodes.push_back(it->second);
    }
    const std::vector<std::int32_t> across = nodes;
    if (const auto loose = loose_.find(face); loose != loose_.end())
      for (const std::int32_t n : loose->second) {
        const Vec3& p = open_.mesh.nodes[n];
        if (crowds_border(p, border)) continue;
        if (!across.empty() && (is_near(p, across) || is_over_facet(n))) continue;
        nodes.push_back(n);
      }
    if (const auto added = added_.find(face); added != added_.end())
      nodes.insert(nodes.end(), added->second.begin(), added->second.end());
    return nodes;
  }

  [[nodiscard]] bool is_near(const Vec3& p, const std::vector<std::int32_t>& nodes) const {
    const double closest = kCoverLimits.closest * sizes_(p);
    return std::ranges::any_of(
        nodes, [&](std::int32_t n) { return norm2(open_.mesh.nodes[n] - p) < closest * closest; });
  }

  /// Nodes that a face may need counterparts of: on the borders of other faces, and of the facets
  /// that faces covered before have.
  [[nodiscard]] std::vector<std::int32_t> film_nodes(std::int32_t face) const {
    std::vector<std::int32_t> nodes;
    for (const auto& [other, border] : borders_)
      if (other != face)
        for (const BorderSide& s : border)
          for (const std::int32_t n : {s.side.first, s.side.second}) nodes.push_back(n);
    for (std::size_t k = kept_; k < open_.mesh.facets.size(); ++k)
      for (const std::int32_t n : open_.mesh.facets[k].nodes) nodes.push_back(n);
    sort_unique(nodes);
    return nodes;
  }

  /// Whether a new facet, of a face covered before, lies across a film from a node.
  [[nodiscard]] bool is_over_facet(std::int32_t node) const {
    const auto& p = open_.mesh.nodes;
    const double film = kCoverLimits.film * sizes_(p[node]);
    for (std::size_t k = kept_; k < open_.mesh.facets.size(); ++k) {
      const FaceFacet& f = open_.mesh.facets[k];
      if (distance(p[node], p[f.nodes[0]]) >
          film + distance(p[f.nodes[0]], p[f.nodes[1]]) + distance(p[f.nodes[0]], p[f.nodes[2]]))
        continue;
      if (triangle_distance2(p[node], {p[f.nodes[0]], p[f.nodes[1]], p[f.nodes[2]]}) < film * film)
        return true;
    }
    return false;
  }

  std::string cover_face(std::int32_t face, const std::vector<BorderSide>& border) {
    SurfaceMesh& mesh = open_.mesh;
    const std::vector<std::int32_t> inner = inner_nodes(face, border);
    std::vector<Vec3> points;
    for (const BorderSide& s : border)
      for (const std::int32_t n : {s.side.first, s.side.second}) points.push_back(mesh.nodes[n]);
    const std::optional<FlatMap> map = FlatMap::of(boundary_.faces[face].surface, points);
    if (!map) return "a torus that is open all round cannot be flattened";
    const kernel::Border flat = flat_border(border, *map);
    std::vector<std::array<double, 2>> flat_inner;
    for (const std::int32_t n : inner) flat_inner.push_back((*map)(mesh.nodes[n]));
    const auto triangles = kernel::mesh_border(flat, flat_inner);
    if (!triangles) return halve_crossing(face, flat);
    const auto corners = static_cast<int>(flat.corners.size());
    const auto node = [&](int c) {
      return c < corners ? flat.corners[c].node : inner[c - corners];
    };
    const std::size_t first = mesh.facets.size();
    double outward = 0;  // area as seen from outside
    for (const auto& t : *triangles) {
      const Triangle nodes{node(t[0]), node(t[1]), node(t[2])};
      mesh.facets.push_back({nodes, {-1, -1, -1}, face});
      outward += dot(area_vector(nodes), face_normal(face, nodes));
    }
    if (outward < 0)
      for (std::size_t k = first; k < mesh.facets.size(); ++k)
        std::swap(mesh.facets[k].nodes[1], mesh.facets[k].nodes[2]);
    return {};
  }

  void halve_link(const Side& side) { changed_ = sides_.halve_link(side) || changed_; }

  /// Halves links at places where segments of a border cross. Returns why the face cannot be
  /// covered where no link there may be halved, else nothing.
  std::string halve_crossing(std::int32_t face, const kernel::Border& flat) {
    const auto side = [&](const kernel::Border::Segment& s) {
      return side_of(flat.corners[s.a].node, flat.corners[s.b].node);
    };
    bool any = false;
    for (const auto& [i, j] : kernel::crossing_segments(flat)) {
      const kernel::Border::Segment &s = flat.segments[i], &t = flat.segments[j];
      const bool split_s = s.edge >= 0 && sides_.may_halve(side(s));
      const bool split_t = t.edge >= 0 && sides_.may_halve(side(t));
      if (!split_s && !split_t) continue;
      any = true;
      halve_link(split_s && (!split_t || sides_.length(side(s)) >= sides_.length(side(t)))
                     ? side(s)
                     : side(t));
    }
    return any ? std::string()
               : "a face called " + boundary_.faces[face].names.front().face +
                     " could not be covered between what stays";
  }

  [[nodiscard]] Vec3 area_vector(const Triangle& t) const {
    const auto& p = open_.mesh.nodes;
    return cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
  }
  [[nodiscard]] Vec3 face_normal(std::int32_t face, const Triangle& t) const {
    const auto& p = open_.mesh.nodes;
    return outward_normal(boundary_.faces[face], (1.0 / 3) * (p[t[0]] + p[t[1]] + p[t[2]]));
  }

  /// Halves the longest sides of a facet that may be halved.
  void refine(std::int32_t facet) {
    const FaceFacet f = open_.mesh.facets[facet];
    double longest = 0;
    std::vector<Side> sides;
    for (int i = 0; i < 3; ++i) {
      const Side s = side_of(f.nodes[i], f.nodes[(i + 1) % 3]);
      if (!sides_.may_halve(s)) continue;
      sides.push_back(s);
      longest = std::fmax(longest, sides_.length(s));
    }
    for (const Side& s : sides) {
      if (sides_.length(s) < kCoverLimits.long_share * longest || !halved_.insert(s).second)
        continue;
      if (sides_.is_link(s)) {
        halve_link(s);
      } else {
        const auto& p = open_.mesh.nodes;
        added_[f.face].push_back(
            sides_.add_node({Support::Kind::Face, f.face}, 0.5 * (p[s.first] + p[s.second])));
        changed_ = true;
      }
    }
  }

  /// Makes new facets smaller that cut others. Returns whether there are any.
  bool refine_crossings() {
    SurfaceMesh all = {open_.mesh.nodes, {}, near_facets()};
    const auto crossings = surface_crossings(all, run_);
    bool any = false;
    halved_.clear();
    for (const auto& [s, t] : crossings)
      for (const std::int32_t k : {s, t})
        if (from_[k] >= static_cast<std::int32_t>(kept_)) refine(from_[k]);
    for (const auto& [s, t] : crossings)
      any = any || from_[s] >= static_cast<std::int32_t>(kept_) ||
            from_[t] >= static_cast<std::int32_t>(kept_);
    if (any && !changed_) stuck_ = "facets of the boundary cut each other beside what stays";
    return any;
  }

  /// Makes new facets smaller that stand off their curved faces. Returns whether it did.
  bool refine_bent() {
    halved_.clear();
    const std::size_t end = open_.mesh.facets.size();
    for (std::size_t k = kept_; k < end; ++k) {
      const FaceFacet& f = open_.mesh.facets[k];
      const Vec3 area = area_vector(f.nodes);
      if (dot(area, face_normal(f.face, f.nodes)) < kCoverLimits.least_cosine * norm(area))
        refine(static_cast<std::int32_t>(k));
    }
    return changed_;
  }

  /// Makes new facets smaller, once, where that is asked for (`finer_at`). Returns whether it did.
  bool refine_asked() {
    if (std::exchange(asked_, true)) return false;
    halved_.clear();
    const auto& p = open_.mesh.nodes;
    const std::size_t end = open_.mesh.facets.size();
    for (std::size_t k = kept_; k < end; ++k) {
      const Triangle t = open_.mesh.facets[k].nodes;
      const double reach2 =
          std::max({norm2(p[t[0]] - p[t[1]]), norm2(p[t[1]] - p[t[2]]), norm2(p[t[2]] - p[t[0]])});
      if (std::ranges::any_of(open_.finer_at, [&](const Vec3& place) {
            return triangle_distance2(place, {p[t[0]], p[t[1]], p[t[2]]}) < 0.25 * reach2;
          }))
        refine(static_cast<std::int32_t>(k));
    }
    return changed_;
  }

  /// The new facets, the walls, and the facets that stay near the new ones. `from_` gets their
  /// numbers in `open_.mesh`, -1 for walls.
  std::vector<FaceFacet> near_facets() {
    from_.clear();
    std::vector<FaceFacet> near;
    Box box;
    const auto take = [&](const FaceFacet& f, std::int32_t number) {
      near.push_back(f);
      from_.push_back(number);
    };
    for (std::size_t k = kept_; k < open_.mesh.facets.size(); ++k) {
      take(open_.mesh.facets[k], static_cast<std::int32_t>(k));
      for (const std::int32_t n : open_.mesh.facets[k].nodes) box.add(open_.mesh.nodes[n]);
    }
    for (const Triangle& w : open_.walls) take({w, {-1, -1, -1}, -1}, -1);
    for (std::size_t k = 0; k < kept_; ++k) {
      Box own;
      for (const std::int32_t n : open_.mesh.facets[k].nodes) own.add(open_.mesh.nodes[n]);
      if (touch(box, own)) take(open_.mesh.facets[k], static_cast<std::int32_t>(k));
    }
    return near;
  }

  OpenSurface& open_;
  const BoundaryModel& boundary_;
  const SizeField& sizes_;
  const Run& run_;
  std::size_t kept_;  ///< facets that stay
  OpenBorders sides_;
  std::map<std::int32_t, std::vector<std::int32_t>> loose_, added_;  ///< by face
  /// By face and node: the node across a film on that face.
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> counterparts_;
  std::map<std::int32_t, std::vector<BorderSide>> borders_;  ///< by face
  std::set<Side> halved_;                                    ///< in this round
  std::vector<std::int32_t> from_;
  bool changed_ = false, asked_ = false;
  std::string stuck_;
};

}  // namespace

std::string cover_open_faces(OpenSurface& open, const BoundaryModel& boundary,
                             const SizeField& sizes, const Run& run) {
  return Cover(open, boundary, sizes, run).cover();
}

}  // namespace remeshd
