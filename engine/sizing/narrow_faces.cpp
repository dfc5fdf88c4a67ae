#include "engine/sizing/narrow_faces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "engine/sizing/face_neighbours.h"

namespace remeshd {

namespace {

struct StripLimits {
  double steepest = 0.3;  ///< sine of the angle between a strip's edges, at most
  double level = 0.1;     ///< the same where it is widest
  double aside = 0.5;  ///< cosine between an edge and the shortest way to the other, at most: else
                       ///< the other goes on from the edge and is not beside it
  double share = 0.5;  ///< of the greatest width: where a strip is narrower it is left out
};
constexpr StripLimits kStripLimits;

struct Segment {
  Vec3 a, b;
};

Vec3 nearest_on(const Segment& s, const Vec3& p) {
  const Vec3 along = s.b - s.a;
  const double length2 = norm2(along);
  if (length2 == 0) return s.a;
  return s.a + std::clamp(dot(p - s.a, along) / length2, 0.0, 1.0) * along;
}

/// An edge of a face, and the face beyond it.
struct Side {
  const BoundaryEdge& edge;
  const BoundaryFace& beyond;
};

/// Looks for the strips of a face along one edge.
class StripSearch {
 public:
  /// `others`: the edges of the face that may run along that one.
  StripSearch(int face, const Side& side, std::vector<Side> others, const NarrowFaceLimits& limits,
              std::vector<NarrowPlace>& places)
      : face_(face), side_(side), others_(std::move(others)), limits_(limits), places_(places) {}

  void search(Polling& poll) {
    const std::vector<Vec3>& points = side_.edge.points;
    for (std::size_t k = 1; k < points.size(); ++k) visit({points[k - 1], points[k]}, poll);
    end_strip();
  }

 private:
  struct Nearest {
    double distance = HUGE_VAL;
    Vec3 at, along;
    const BoundaryFace* beyond = nullptr;  ///< not owned
  };
  struct Piece {
    Segment segment;
    double width, slope;
  };

  [[nodiscard]] Nearest nearest(const Vec3& p) const {
    Nearest found;
    for (const Side& other : others_)
      for (std::size_t k = 1; k < other.edge.points.size(); ++k) {
        const Segment s{other.edge.points[k - 1], other.edge.points[k]};
        const Vec3 at = nearest_on(s, p);
        if (const double d = distance(at, p); d < found.distance)
          found = {d, at, s.b - s.a, &other.beyond};
      }
    return found;
  }

  /// Adds a segment of the edge to the strip, in pieces, or ends the strip.
  void visit(const Segment& s, Polling& poll) {
    poll();
    const double length = distance(s.a, s.b);
    const Vec3 middle = 0.5 * (s.a + s.b);
    const Nearest other = nearest(middle);
    if (length == 0) return;
    if (other.distance - 0.5 * length >= limits_.most) return end_strip();
    if (length > std::max(other.distance, limits_.least)) {
      visit({s.a, middle}, poll);
      visit({middle, s.b}, poll);
      return;
    }
    const Vec3 along = normalised(s.b - s.a);
    const double slope = norm(cross(along, normalised(other.along)));
    const bool narrow = other.distance >= limits_.film && other.distance < limits_.most &&
                        slope <= kStripLimits.steepest;
    const bool aside =
        std::fabs(dot(along, other.at - middle)) <= kStripLimits.aside * other.distance;
    if (narrow && aside && is_step(middle, other))
      strip_.push_back({s, other.distance, slope});
    else
      end_strip();
  }

  [[nodiscard]] bool is_step(const Vec3& p, const Nearest& other) const {
    return dot(outward_normal(side_.beyond, p), outward_normal(*other.beyond, other.at)) > 0;
  }

  void end_strip() {
    const auto widest = std::ranges::max_element(strip_, {}, &Piece::width);
    if (widest != strip_.end() && widest->slope <= kStripLimits.level)
      for (const auto& [segment, width, slope] : strip_)
        if (width >= kStripLimits.share * widest->width)
          places_.push_back({face_, {segment.a, segment.b}, width});
    strip_.clear();
  }

  int face_;
  Side side_;
  std::vector<Side> others_;
  const NarrowFaceLimits& limits_;
  std::vector<NarrowPlace>& places_;
  std::vector<Piece> strip_;
};

/// The face on the other side of an edge of a face; that face itself where it lies on both sides.
int beyond(const BoundaryEdge& edge, int face) {
  return edge.faces.front() == face ? edge.faces.back() : edge.faces.front();
}

}  // namespace

std::vector<NarrowPlace> narrow_faces(const BoundaryModel& boundary, const NarrowFaceLimits& limits,
                                      const Run& run) {
  const auto neighbours = face_neighbours(boundary);
  const auto side = [&](int face, int edge) -> Side {
    return {boundary.edges[edge], boundary.faces[beyond(boundary.edges[edge], face)]};
  };
  std::vector<NarrowPlace> places;
  Polling poll(run);
  for (int f = 0; f < std::ssize(boundary.faces); ++f)
    for (const int e : boundary.faces[f].edges) {
      const std::vector<int>& meeting = neighbours[beyond(boundary.edges[e], f)];
      std::vector<Side> others;
      for (const int other : boundary.faces[f].edges)
        if (other != e && std::ranges::binary_search(meeting, beyond(boundary.edges[other], f)))
          others.push_back(side(f, other));
      if (!others.empty())
        StripSearch(f, side(f, e), std::move(others), limits, places).search(poll);
    }
  return places;
}

}  // namespace remeshd
