#include "engine/extract/peel.h"

#include <algorithm>
#include <limits>

#include "engine/base/parallel.h"
#include "engine/boundary/facet_faces.h"
#include "engine/extract/facet_side.h"
#include "engine/mesh/quality.h"

namespace remeshd {

namespace {

/// What a tet is before flat tets on curved faces are peeled.
enum class Place : std::uint8_t {
  Outside,
  Inside,
  OnPlane,  ///< flat, its nodes on a plane face: inside where it is between tets that are
};

/// Stands for a neighbour in the model that is not in the patch.
constexpr std::int32_t kBeyond = std::numeric_limits<std::int32_t>::max();

template <std::size_t kCorners>
int face_of(const NodeSet& nodes, const FacesOf& faces,
            const std::array<std::int32_t, kCorners>& corners) {
  std::array<Support, kCorners> supports;
  std::ranges::transform(corners, supports.begin(),
                         [&](std::int32_t n) { return nodes.supports[n]; });
  return faces.common(supports);
}

// x the way from the middle of an edge to the centroid of its tet.
constexpr double kOffTheEdge = 1e-6;

/// Whether an edge of the tet between nodes of different faces leaves the model, as does one from
/// side to side of a gap. The point tested is its middle, moved a little into the tet: the middle
/// itself may lie where two features touch, and by rounding in neither.
bool reaches_out(const NodeSet& nodes, const FacesOf& faces, const InsideTest& inside,
                 const Tet& t) {
  const Vec3 within = centroid(nodes.positions, t);
  for (int i = 1; i < 4; ++i)
    for (int j = 0; j < i; ++j) {
      const Vec3 middle = 0.5 * (nodes.positions[t[i]] + nodes.positions[t[j]]);
      if (face_of<2>(nodes, faces, {t[i], t[j]}) < 0 &&
          !inside(middle + kOffTheEdge * (within - middle)))
        return true;
    }
  return false;
}

// Cosine of 60 degrees: surface normals at the corners of a shallow tet differ by less.
constexpr double kShallow = 0.5;

/// Finds tets whose nodes lie on one curved surface, on both sides of a group's rim
/// (BoundaryEdge::rim), and which are shallow: they lie between the surface and facets below them.
/// Left out of the mesh, they uncover those facets, which follow the rim.
class TetsAcrossRims {
 public:
  TetsAcrossRims(const NodeSet& nodes, const BoundaryModel& boundary)
      : nodes_(nodes),
        boundary_(boundary),
        faces_(boundary),
        across_rims_(FacesOf::across_rims(boundary)),
        any_(std::ranges::any_of(boundary.edges, &BoundaryEdge::rim)) {}

  [[nodiscard]] bool has(const Tet& t) const {
    if (!any_) return false;
    const int sheet = face_of(nodes_, across_rims_, t);
    if (sheet < 0 || boundary_.faces[sheet].surface.kind == Surface::Kind::Plane ||
        face_of(nodes_, faces_, t) >= 0)
      return false;
    std::array<Vec3, 4> normals;
    std::ranges::transform(t, normals.begin(), [&](std::int32_t n) {
      return outward_normal(boundary_.faces[sheet], nodes_.positions[n]);
    });
    return std::ranges::all_of(kTetEdges, [&](const auto& edge) {
      return dot(normals[edge[0]], normals[edge[1]]) > kShallow;
    });
  }
  /// The faces that nodes lie on.
  [[nodiscard]] const FacesOf& faces() const { return faces_; }
  /// The same, with faces that only rims of groups separate as one.
  [[nodiscard]] const FacesOf& sheets() const { return across_rims_; }

 private:
  const NodeSet& nodes_;
  const BoundaryModel& boundary_;
  const FacesOf faces_, across_rims_;
  const bool any_;
};

Place place_of(const NodeSet& nodes, const BoundaryModel& boundary, const TetsAcrossRims& rims,
               const InsideTest& inside, const Tet& t, bool by_centroid_only) {
  const auto of = [](bool in_model) { return in_model ? Place::Inside : Place::Outside; };
  for (const std::int32_t n : t)
    if (nodes.supports[n].kind == Support::Kind::Interior) return Place::Inside;
  if (rims.has(t)) return Place::Outside;
  const FacesOf& faces = rims.sheets();
  const int face = face_of(nodes, faces, t);
  if (face >= 0 && boundary.faces[face].surface.kind == Surface::Kind::Plane)
    return by_centroid_only ? Place::Outside : Place::OnPlane;
  if (by_centroid_only) return of(inside(centroid(nodes.positions, t)));
  if (face < 0)
    if (const BoundarySide side = side_by_facets(nodes, boundary, rims.faces(), t);
        side != BoundarySide::Unknown)
      return of(side == BoundarySide::Inside);
  return of(inside(centroid(nodes.positions, t)) && !reaches_out(nodes, faces, inside, t));
}

/// Peels flat tets off the tets in the model, and those that were peeled before the edit, too.
class Peeling {
 public:
  using Known = KnownClassification::Known;

  Peeling(const NodeSet& nodes, const DelaunayMesh& delaunay, const BoundaryModel& boundary,
          const FacesOf& faces, const KnownClassification& known, const PeelOptions& options)
      : nodes_(nodes),
        delaunay_(delaunay),
        boundary_(boundary),
        faces_(faces),
        known_(known),
        options_(options) {}

  /// `places`: by slot.
  PeeledMesh peel(std::vector<Place> places) {
    place_those_on_planes(places);
    gather(places);
    gone_.assign(mesh_.tets.size(), 0);
    for (std::size_t k = 0; k < mesh_.tets.size(); ++k)
      if (is_exposed(k)) queue_.push_back(static_cast<std::int32_t>(k));
    work_off();
    // Tets that were peeled before the edit go one at a time: in between a neighbour may expose
    // just two facets, and be peeled, before it exposes more.
    for (std::size_t k = 0; k < mesh_.tets.size(); ++k) {
      if (gone_[k] || known_of(mesh_.slots[k]) != Known::Outside) continue;
      peel_off(k);
      work_off();
    }
    keep_the_rest();
    return std::move(mesh_);
  }

  [[nodiscard]] Known known_of(std::int32_t slot) const { return known_.tets[slot]; }

 private:
  /// Places flat tets in the plane of a face inside where all round them is, as within the rim of a
  /// pin that stands on the face: without them a void would be left, between facets that cut each
  /// other. Clean-up takes them out by flips. On the face itself they are outside.
  void place_those_on_planes(std::vector<Place>& places) const {
    std::vector<std::int32_t> flat;
    for (std::size_t k = 0; k < places.size(); ++k)
      if (places[k] == Place::OnPlane) flat.push_back(static_cast<std::int32_t>(k));
    const auto meets_outside = [&](std::int32_t slot) {
      const Tet across = delaunay_.across(slot);
      for (int i = 0; i < 4; ++i) {
        const std::int32_t exterior = delaunay_.exterior(slot, i);
        if (exterior >= 0 ? known_.exterior[exterior] == 0
                          : across[i] < 0 || places[across[i]] == Place::Outside)
          return true;
      }
      return false;
    };
    for (std::size_t before = flat.size() + 1; flat.size() < before;) {
      before = flat.size();
      std::erase_if(flat, [&](std::int32_t slot) {
        if (!meets_outside(slot)) return false;
        places[slot] = Place::Outside;
        return true;
      });
    }
    for (const std::int32_t slot : flat) places[slot] = Place::Inside;
  }

  /// Gathers the tets in the model and, by tet, what is across each facet: a tet's index, kBeyond,
  /// or -1 where that is outside of the model.
  void gather(const std::vector<Place>& places) {
    mesh_.tets.reserve(delaunay_.size());
    mesh_.slots.reserve(delaunay_.size());
    neighbours_.reserve(delaunay_.size());
    std::vector<std::int32_t> number(delaunay_.slots(), -1);
    delaunay_.for_each_tet_with_neighbours([&](std::int32_t slot, const Tet& t, const Tet& across) {
      if (places[slot] == Place::Outside) return;
      number[slot] = static_cast<std::int32_t>(mesh_.tets.size());
      mesh_.tets.push_back(t);
      mesh_.slots.push_back(slot);
      neighbours_.push_back(across);
    });
    for (std::size_t k = 0; k < neighbours_.size(); ++k)
      for (int i = 0; i < 4; ++i) {
        std::int32_t& across = neighbours_[k][i];
        const std::int32_t exterior = delaunay_.exterior(mesh_.slots[k], i);
        if (exterior >= 0)
          across = known_.exterior[exterior] != 0 ? kBeyond : -1;
        else
          across = across < 0 ? -1 : number[across];
      }
  }

  /// Whether so many facets are exposed that a flat tet is peeled. A tet that was outside before
  /// the edit may expose three at once: neighbours peeled after it then may be beyond the patch
  /// now, and outside from the start.
  [[nodiscard]] bool is_exposed(std::size_t k) const {
    const auto shown = std::count(neighbours_[k].begin(), neighbours_[k].end(), -1);
    switch (known_of(mesh_.slots[k])) {
      case Known::No:
        return (shown == 2 && shows_its_face_alone(k)) || (shown == 3 && shows_its_back(k));
      case Known::WasOutside:
        return shown >= 2;
      default:
        return false;
    }
  }
  /// Whether the exposed facets all represent the face that the tet lies on. Else one is on a plane
  /// that meets this, as on the top of a cone that is cut off just below its apex: a thin tet there
  /// is no chord's sliver, and what is below it is not on the plane.
  [[nodiscard]] bool shows_its_face_alone(std::size_t k) const {
    if (options_.by_centroid_only) return true;  // even meshes stay as older versions made them
    const Tet& t = mesh_.tets[k];
    const int face = face_of(nodes_, faces_, t);
    for (int i = 0; i < 4; ++i) {
      const auto& f = kTetFacets[i];
      if (neighbours_[k][i] == -1 &&
          face_of<3>(nodes_, faces_, {t[f[0]], t[f[1]], t[f[2]]}) != face)
        return false;
    }
    return true;
  }
  /// Whether an exposed facet looks away from the face that the tet lies on, as where the face ends
  /// at a step that the tet reaches over: there is nothing before the tet nor behind it.
  [[nodiscard]] bool shows_its_back(std::size_t k) const {
    const Tet& t = mesh_.tets[k];
    const int face = face_of(nodes_, faces_, t);
    if (face < 0) return false;
    for (int i = 0; i < 4; ++i) {
      if (neighbours_[k][i] != -1) continue;
      const auto& p = nodes_.positions;
      const auto& f = kTetFacets[i];
      const Vec3 &a = p[t[f[0]]], &b = p[t[f[1]]], &c = p[t[f[2]]];
      const Vec3 outward = outward_normal(boundary_.faces[face], (a + b + c) / 3.0);
      if (dot(cross(b - a, c - a), outward) < 0) return true;
    }
    return false;
  }
  [[nodiscard]] bool is_flat(const Tet& t) const {
    return face_of(nodes_, faces_, t) >= 0 && volume_length(nodes_.positions, t) < options_.flat;
  }
  void peel_off(std::size_t k) {
    gone_[k] = 1;
    for (const std::int32_t n : neighbours_[k]) {
      if (n < 0 || n == kBeyond) continue;
      std::ranges::replace(neighbours_[n], static_cast<std::int32_t>(k), -1);
      if (is_exposed(n)) queue_.push_back(n);
    }
  }
  void work_off() {
    for (; next_ < queue_.size(); ++next_)
      if (const std::int32_t k = queue_[next_];
          !gone_[k] && is_exposed(k) && is_flat(mesh_.tets[k]))
        peel_off(k);
  }

  /// Compacts the arrays of tets and notes nonconforming facets.
  void keep_the_rest() {
    std::vector<Tet>& tets = mesh_.tets;
    const auto& p = nodes_.positions;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < tets.size(); ++k) {
      if (gone_[k]) continue;
      for (int i = 0; i < 4; ++i) {
        if (neighbours_[k][i] >= 0) continue;
        const auto& f = kTetFacets[i];
        const Triangle facet{tets[k][f[0]], tets[k][f[1]], tets[k][f[2]]};
        if (face_of(nodes_, faces_, facet) >= 0) continue;
        mesh_.nonconforming.push_back((p[facet[0]] + p[facet[1]] + p[facet[2]]) / 3.0);
      }
      mesh_.slots[kept] = mesh_.slots[k];
      tets[kept++] = tets[k];
    }
    tets.resize(kept);
    mesh_.slots.resize(kept);
  }

  const NodeSet& nodes_;
  const DelaunayMesh& delaunay_;
  const BoundaryModel& boundary_;
  const FacesOf& faces_;
  const KnownClassification& known_;
  const PeelOptions& options_;
  PeeledMesh mesh_;
  std::vector<Tet> neighbours_;  ///< by tet
  std::vector<std::uint8_t> gone_;
  std::vector<std::int32_t> queue_;  ///< tets that were exposed when queued
  std::size_t next_ = 0;             ///< in the queue
};

}  // namespace

PeeledMesh peel(const NodeSet& nodes, const DelaunayMesh& delaunay, const BoundaryModel& boundary,
                const InsideTest& inside, const KnownClassification& known,
                const PeelOptions& options, const Run& run) {
  const FacesOf faces(boundary);
  const TetsAcrossRims rims(nodes, boundary);
  Peeling peeling(nodes, delaunay, boundary, faces, known, options);
  std::vector<Place> places(delaunay.slots(), Place::Outside);
  in_blocks(delaunay.slots(), kFairBlock, run, [&](std::size_t begin, std::size_t end) {
    run.poll();
    for (auto slot = static_cast<std::int32_t>(begin); slot < static_cast<std::int32_t>(end);
         ++slot) {
      const Tet t = delaunay.corners(slot);
      if (!delaunay.in_use(slot) || std::ranges::min(t) < 0) continue;
      places[slot] = peeling.known_of(slot) == KnownClassification::Known::Inside
                         ? Place::Inside
                         : place_of(nodes, boundary, rims, inside, t, options.by_centroid_only);
    }
  });
  return peeling.peel(std::move(places));
}

}  // namespace remeshd
