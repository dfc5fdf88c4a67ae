#include "engine/sizing/thin_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "engine/base/parallel.h"
#include "engine/sizing/face_neighbours.h"
#include "engine/sizing/triangle_tree.h"

namespace remeshd {

namespace {

struct PlaceLimits {
  double even = 1.5;           ///< greatest thickness on a place over the least
  double smallest = 1;         ///< x thickness: radius below which an uneven place is not bisected
  double largest = 1;          ///< x `most`: radius above which a triangle is always bisected
  double cube = 0.15;          ///< x `most`: side of the cubes that keep one probe each
  double rounding = 1 + 1e-9;  ///< factor on a bound, so that rounding leaves nothing out
  std::size_t faces_at_once = 4;  ///< on one thread
};
constexpr PlaceLimits kPlaceLimits;

using Corners = std::array<Vec3, 3>;

/// A corner of triangles of a face.
struct Corner {
  Vec3 at;
  mutable double to_others = -1;  ///< distance to faces that are no neighbours; -1: not yet known
};

/// A triangle of a face, with a ball round it.
struct Patch {
  int face;
  std::array<const Corner*, 3> corners;  ///< not owned
  Vec3 middle;
  double radius;

  Patch(int of_face, const std::array<const Corner*, 3>& c)
      : face(of_face), corners(c), middle((1.0 / 3) * (c[0]->at + c[1]->at + c[2]->at)), radius(0) {
    for (const Corner* corner : c) radius = std::max(radius, distance(middle, corner->at));
  }
  [[nodiscard]] Corners triangle() const {
    return {corners[0]->at, corners[1]->at, corners[2]->at};
  }
};

class Search {
 public:
  /// `tree`: of all of the boundary.
  Search(const BoundaryModel& boundary, const TriangleTree& tree, const ThinPlaceLimits& limits,
         const Run& run)
      : boundary_(boundary),
        tree_(tree),
        most_(limits.most),
        least_(limits.least),
        film_(limits.film),
        poll_(run),
        neighbours_(boundary.faces.size(), 0),
        others_(boundary.faces.size(), 1) {}

  /// Adds the places of a face. `neighbours`: those of the face, and itself.
  void search(int face, std::span<const int> neighbours) {
    for (const int f : neighbours) neighbours_[f] = 1;
    others_[face] = 0;
    const BoundaryFace& searched = boundary_.faces[face];
    std::vector<Corner> corners;
    for (const Vec3& p : searched.points) corners.push_back({p});
    for (const auto& t : searched.triangles)
      visit({face, {&corners[t[0]], &corners[t[1]], &corners[t[2]]}}, HUGE_VAL);
    for (const int f : neighbours) neighbours_[f] = 0;
    others_[face] = 1;
  }

  std::vector<ThinPlace> take() { return std::move(places_); }

 private:
  /// The thickness all over a patch.
  struct Thickness {
    double least, greatest;
    bool film, thinner;
  };

  /// Adds the places of a patch. Where the thickness is nearly even all over it, that is one place,
  /// and the thickness is returned. `within`: bound of the distance of its middle from faces that
  /// are no neighbours; infinite where none is known.
  std::optional<Thickness> visit(const Patch& patch, double within) {
    poll_();
    const TriangleTree::Nearest nearest =
        tree_.nearest(patch.middle, std::min(most_ + patch.radius, within), neighbours_);
    if (!nearest.found) return std::nullopt;
    if (patch.radius > kPlaceLimits.largest * most_) return visit_halves(patch, nearest.at);
    double least = nearest.distance, greatest = nearest.distance;
    for (const Corner* corner : patch.corners) {
      const double d = distance_to_others(*corner, nearest.at);
      least = std::min(least, d);
      greatest = std::max(greatest, d);
    }
    if (greatest < film_) return add(patch, {least, greatest, true, true});
    const bool thinner = least < least_;
    least = std::max(least, least_);
    if (greatest > kPlaceLimits.even * least && patch.radius > kPlaceLimits.smallest * least)
      return visit_halves(patch, nearest.at);
    if (least >= most_) return std::nullopt;
    // Beside a film, where this face ends, the nearest point opposite is nearer to this face than
    // to the patch.
    const double film = tree_.nearest(nearest.at, film_, others_).distance;
    if (film < film_) return add(patch, {film, film, true, true});
    return add(patch, {least, std::max(least, greatest), false, thinner});
  }

  /// Adds the places of both halves, or one for all of the patch where it is nearly even.
  /// `on_other`: a point of a face that is no neighbour.
  std::optional<Thickness> visit_halves(const Patch& patch, const Vec3& on_other) {
    const std::size_t before = places_.size();
    const auto visit_half = [&](const Corner* a, const Corner* b, const Corner* c) {
      const Patch half(patch.face, {a, b, c});
      return visit(half, kPlaceLimits.rounding * distance(half.middle, on_other));
    };
    const int k = opposite_longest_side(patch.triangle());
    const Corner *a = patch.corners[k], *b = patch.corners[(k + 1) % 3],
                 *c = patch.corners[(k + 2) % 3];
    const Corner between{0.5 * (b->at + c->at)};
    const auto one = visit_half(a, b, &between), other = visit_half(a, &between, c);
    if (!one || !other || one->film != other->film) return std::nullopt;
    const Thickness both{std::min(one->least, other->least),
                         std::max(one->greatest, other->greatest), one->film,
                         one->thinner || other->thinner};
    if (!both.film && both.greatest > kPlaceLimits.even * both.least) return std::nullopt;
    places_.erase(places_.begin() + static_cast<std::ptrdiff_t>(before), places_.end());
    return add(patch, both);
  }

  Thickness add(const Patch& patch, const Thickness& thickness) {
    places_.push_back({patch.face, patch.triangle(), thickness.least, thickness.thinner});
    return thickness;
  }

  /// `on_one`: a point of a face that is no neighbour.
  [[nodiscard]] double distance_to_others(const Corner& corner, const Vec3& on_one) const {
    if (corner.to_others < 0)
      corner.to_others =
          tree_.nearest(corner.at, distance(corner.at, on_one), neighbours_).distance;
    return corner.to_others;
  }

  static int opposite_longest_side(const Corners& c) {
    int at = 0;
    double longest = -1;
    for (int k = 0; k < 3; ++k) {
      const double side = distance(c[(k + 1) % 3], c[(k + 2) % 3]);
      if (side > longest) longest = side, at = k;
    }
    return at;
  }

  const BoundaryModel& boundary_;
  const TriangleTree& tree_;
  double most_, least_, film_;
  Polling poll_;
  std::vector<std::uint8_t> neighbours_;  ///< by face: 1 for those of the face searched, and it
  std::vector<std::uint8_t> others_;      ///< by face: 1 for all but the face searched
  std::vector<ThinPlace> places_;
};

/// Thin places that have been kept. One of them covers another place if, at every corner of the
/// other, its thickness plus the slope times the distance from it is at most the other's thickness.
class Covering {
 public:
  explicit Covering(const ThinPlaceLimits& limits) : limits_(limits) {}

  [[nodiscard]] bool covers(const ThinPlace& place) const {
    const Cube cube = cube_of(middle_of(place.triangle), limits_.most);
    for (int k = 0; k < 27; ++k) {
      const auto found =
          probes_.find({cube[0] + k % 3 - 1, cube[1] + k / 3 % 3 - 1, cube[2] + k / 9 - 1});
      if (found != probes_.end() && std::ranges::any_of(found->second, [&](const Probe& probe) {
            return covers(probe, place);
          }))
        return true;
    }
    return false;
  }
  void add(const ThinPlace& place) {
    for (const Vec3& corner : place.triangle) add(corner, place.thickness);
    add(middle_of(place.triangle), place.thickness);
  }

 private:
  using Cube = std::array<long, 3>;
  struct Probe {
    Vec3 at;
    double thickness;
  };

  static Vec3 middle_of(const Corners& c) { return (1.0 / 3) * (c[0] + c[1] + c[2]); }
  static Cube cube_of(const Vec3& p, double side) {
    return {std::lround(p.x / side), std::lround(p.y / side), std::lround(p.z / side)};
  }
  /// Places come thinnest first, so that the first in a small cube does for all.
  void add(const Vec3& p, double thickness) {
    if (taken_.insert(cube_of(p, kPlaceLimits.cube * limits_.most)).second)
      probes_[cube_of(p, limits_.most)].push_back({p, thickness});
  }
  [[nodiscard]] bool covers(const Probe& probe, const ThinPlace& place) const {
    return std::ranges::all_of(place.triangle, [&](const Vec3& corner) {
      return probe.thickness + limits_.slope * distance(probe.at, corner) <= place.thickness;
    });
  }

  ThinPlaceLimits limits_;
  std::map<Cube, std::vector<Probe>> probes_;  ///< by cubes as long as the greatest thickness
  std::set<Cube> taken_;                       ///< small cubes that have a probe
};

/// The places that no thinner one covers, thinnest first; all films.
std::vector<ThinPlace> without_covered(std::vector<ThinPlace> places,
                                       const ThinPlaceLimits& limits) {
  std::ranges::stable_sort(places, {}, &ThinPlace::thickness);
  Covering covering(limits);
  std::erase_if(places, [&](const ThinPlace& place) {
    if (place.thickness < limits.least) return false;  // a film asks for nothing
    if (covering.covers(place)) return true;
    covering.add(place);
    return false;
  });
  return places;
}

}  // namespace

std::vector<ThinPlace> thin_places(const BoundaryModel& boundary, const ThinPlaceLimits& limits,
                                   const Run& run) {
  const auto neighbours = face_neighbours(boundary);
  const TriangleTree tree(boundary);
  std::vector<ThinPlace> places = collect_in_blocks<ThinPlace>(
      boundary.faces.size(), kPlaceLimits.faces_at_once, run,
      [&](std::size_t begin, std::size_t end, std::vector<ThinPlace>& found) {
        Search search(boundary, tree, limits, run);
        for (std::size_t f = begin; f < end; ++f) search.search(static_cast<int>(f), neighbours[f]);
        found = search.take();
      });
  return without_covered(std::move(places), limits);
}

}  // namespace remeshd
