#include "engine/sizing/thin_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <utility>

#include "engine/cellular/boundary_model/face_distance.h"

namespace remeshd {

namespace {

struct PlaceLimits {
  double even = 1.5;    ///< the greatest thickness of a place over the least
  double smallest = 1;  ///< x thickness: from its middle to its corners, where it is not even
};
constexpr PlaceLimits kLimits;

using Corners = std::array<Vec3, 3>;

/// A triangle of some face, with a ball round it.
struct Patch {
  int face;
  Corners corners;
  Vec3 middle;
  double radius;

  Patch(int of_face, const Corners& c)
      : face(of_face), corners(c), middle((1.0 / 3) * (c[0] + c[1] + c[2])), radius(0) {
    for (const Vec3& corner : c) radius = std::max(radius, distance(middle, corner));
  }
};

/// For each face those that it shares an edge or a vertex with, and itself; ascending.
std::vector<std::vector<int>> neighbours_of(const BoundaryModel& boundary) {
  std::vector<std::vector<int>> faces_at(boundary.vertices.size());
  std::vector<std::vector<int>> neighbours(boundary.faces.size());
  const auto join = [&](std::span<const int> faces) {
    for (const int a : faces)
      for (const int b : faces) neighbours[a].push_back(b);
  };
  for (const BoundaryEdge& edge : boundary.edges) {
    join(edge.faces);
    for (const int vertex : {edge.start, edge.end})
      if (vertex >= 0)
        faces_at[vertex].insert(faces_at[vertex].end(), edge.faces.begin(), edge.faces.end());
  }
  for (const auto& faces : faces_at) join(faces);
  for (std::size_t f = 0; f < neighbours.size(); ++f) {
    neighbours[f].push_back(static_cast<int>(f));
    std::ranges::sort(neighbours[f]);
    const auto twice = std::ranges::unique(neighbours[f]);
    neighbours[f].erase(twice.begin(), twice.end());
  }
  return neighbours;
}

class Search {
 public:
  Search(const BoundaryModel& boundary, const ThinPlaceLimits& limits, const Run& run)
      : most_(limits.most), least_(limits.least), film_(limits.film), poll_(run) {
    for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
      const BoundaryFace& face = boundary.faces[f];
      boxes_.push_back(box_of(face.points));
      first_.push_back(patches_.size());
      for (const auto& t : face.triangles)
        patches_.emplace_back(static_cast<int>(f),
                              Corners{face.points[t[0]], face.points[t[1]], face.points[t[2]]});
    }
    first_.push_back(patches_.size());
  }

  void search(int face, std::span<const int> neighbours) {
    const Vec3 margin{most_, most_, most_};
    const Box near{boxes_[face].lo - margin, boxes_[face].hi + margin};
    std::vector<std::int32_t> others;  // patches
    for (int other = 0; other + 1 < static_cast<int>(first_.size()); ++other) {
      if (std::ranges::binary_search(neighbours, other) || !touch(near, boxes_[other])) continue;
      for (std::size_t t = first_[other]; t < first_[other + 1]; ++t)
        others.push_back(static_cast<std::int32_t>(t));
    }
    std::vector<std::int32_t> own;
    for (std::size_t t = first_[face]; t < first_[face + 1]; ++t)
      own.push_back(static_cast<std::int32_t>(t));
    visit_all(own, others);
  }

  std::vector<ThinPlace> take() { return std::move(places_); }

 private:
  struct Near {
    std::int32_t patch;
    double distance;  ///< from the middle of the one that is visited
  };

  /// Visits patches half by half, each with the others that may be near to one of it.
  void visit_all(std::span<std::int32_t> own, std::span<const std::int32_t> others) {
    if (own.empty() || others.empty()) return;
    if (own.size() == 1) return visit(patches_[own[0]], others);
    Box box;
    for (const std::int32_t o : own) box.add(patches_[o].middle);
    const Vec3 middle = 0.5 * (box.lo + box.hi);
    double radius = 0;
    for (const std::int32_t o : own)
      radius = std::max(radius, distance(middle, patches_[o].middle) + patches_[o].radius);
    double within = most_;  // of the middle there is something, or nothing that matters
    for (const std::int32_t o : others)
      within = std::min(within, distance(middle, patches_[o].middle) + patches_[o].radius);
    std::vector<std::int32_t> near;
    for (const std::int32_t o : others)
      if (distance(middle, patches_[o].middle) - patches_[o].radius <= within + 2 * radius)
        near.push_back(o);
    const Vec3 sides = box.hi - box.lo;
    const double longest = std::max({sides.x, sides.y, sides.z});
    const auto axis = sides.x == longest ? &Vec3::x : sides.y == longest ? &Vec3::y : &Vec3::z;
    const auto half = own.begin() + static_cast<std::ptrdiff_t>(own.size() / 2);
    std::ranges::nth_element(
        own, half, {}, [&](std::int32_t o) { return std::pair(patches_[o].middle.*axis, o); });
    visit_all({own.begin(), half}, near);
    visit_all({half, own.end()}, near);
  }

  void visit(const Patch& patch, std::span<const std::int32_t> others) {
    poll_();
    const double reach = 2 * patch.radius;  // between what is nearest to two of its points
    std::vector<Near> found;
    double nearest = most_ + patch.radius;
    for (const std::int32_t o : others) {
      const Patch& other = patches_[o];
      if (distance(patch.middle, other.middle) - other.radius > nearest + reach) continue;
      const double d = std::sqrt(triangle_distance2(patch.middle, other.corners));
      if (d > nearest + reach) continue;
      found.push_back({o, d});
      nearest = std::min(nearest, d);
    }
    if (nearest - patch.radius >= most_) return;
    std::vector<std::int32_t> near;
    for (const Near& n : found)
      if (n.distance <= nearest + reach) near.push_back(n.patch);
    double least = nearest, greatest = nearest;
    for (const Vec3& corner : patch.corners) {
      const double d = distance_to(corner, near);
      least = std::min(least, d);
      greatest = std::max(greatest, d);
    }
    if (greatest < film_) {
      places_.push_back({patch.face, patch.corners, least});
      return;
    }
    const double thickness = std::max(least, least_);
    if (greatest <= kLimits.even * thickness || patch.radius <= kLimits.smallest * thickness) {
      if (thickness < most_) {
        const double film = thickness_of_film(patch, near);
        places_.push_back({patch.face, patch.corners, film < film_ ? film : thickness});
      }
      return;
    }
    for (const Corners& half : halves_of(patch.corners)) visit(Patch(patch.face, half), near);
  }

  /// How near to a patch's own face that is which it is nearest to: less than to the patch itself
  /// beside a film, which ends there.
  [[nodiscard]] double thickness_of_film(const Patch& patch,
                                         std::span<const std::int32_t> near) const {
    double least2 = HUGE_VAL;
    Vec3 nearest;
    for (const std::int32_t o : near) {
      const Vec3 q = nearest_on_triangle(patch.middle, patches_[o].corners);
      if (norm2(q - patch.middle) >= least2) continue;
      least2 = norm2(q - patch.middle);
      nearest = q;
    }
    double film2 = HUGE_VAL;
    for (std::size_t o = first_[patch.face]; o < first_[patch.face + 1]; ++o)
      if (distance(nearest, patches_[o].middle) - patches_[o].radius < film_)
        film2 = std::min(film2, triangle_distance2(nearest, patches_[o].corners));
    return std::sqrt(film2);
  }

  [[nodiscard]] double distance_to(const Vec3& p, std::span<const std::int32_t> patches) const {
    double least2 = HUGE_VAL;
    for (const std::int32_t o : patches) {
      const double to_ball = distance(p, patches_[o].middle) - patches_[o].radius;
      if (to_ball > 0 && to_ball * to_ball >= least2) continue;
      least2 = std::min(least2, triangle_distance2(p, patches_[o].corners));
    }
    return std::sqrt(least2);
  }

  /// Cut across the longest side.
  static std::array<Corners, 2> halves_of(const Corners& c) {
    int at = 0;  // opposite the longest
    double longest = -1;
    for (int k = 0; k < 3; ++k) {
      const double side = distance(c[(k + 1) % 3], c[(k + 2) % 3]);
      if (side > longest) longest = side, at = k;
    }
    const Vec3 &a = c[at], &b = c[(at + 1) % 3], &d = c[(at + 2) % 3];
    const Vec3 between = 0.5 * (b + d);
    return {Corners{a, b, between}, Corners{a, between, d}};
  }

  double most_, least_, film_;
  Polling poll_;
  std::vector<Box> boxes_;  ///< by face
  std::vector<Patch> patches_;
  std::vector<std::size_t> first_;  ///< by face; one more
  std::vector<ThinPlace> places_;
};

/// Thin places, which a place is left out beside where sizes that grow away from them are less.
class Covering {
 public:
  explicit Covering(const ThinPlaceLimits& limits) : limits_(limits) {}

  [[nodiscard]] bool covers(const ThinPlace& place) const {
    const Cube cube = cube_of(middle_of(place.triangle));
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
  [[nodiscard]] Cube cube_of(const Vec3& p) const {
    return {std::lround(p.x / limits_.most), std::lround(p.y / limits_.most),
            std::lround(p.z / limits_.most)};
  }
  void add(const Vec3& p, double thickness) { probes_[cube_of(p)].push_back({p, thickness}); }
  [[nodiscard]] bool covers(const Probe& probe, const ThinPlace& place) const {
    return std::ranges::all_of(place.triangle, [&](const Vec3& corner) {
      return probe.thickness + limits_.slope * distance(probe.at, corner) <= place.thickness;
    });
  }

  ThinPlaceLimits limits_;
  std::map<Cube, std::vector<Probe>> probes_;
};

/// Leaves what matters beside thinner places.
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
  const auto neighbours = neighbours_of(boundary);
  Search search(boundary, limits, run);
  for (std::size_t f = 0; f < boundary.faces.size(); ++f)
    search.search(static_cast<int>(f), neighbours[f]);
  return without_covered(search.take(), limits);
}

}  // namespace remeshd
