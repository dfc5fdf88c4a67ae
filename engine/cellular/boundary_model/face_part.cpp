#include "engine/cellular/boundary_model/face_part.h"

#include <algorithm>
#include <cmath>

namespace remeshd {

namespace {

struct PartLimits {
  // Lengths of a triangle's longest side, x the diagonal of the face's box.
  double first = 1.0 / 16;       ///< longer triangles are bisected before the condition is tested
  double shortest = 1.0 / 1000;  ///< no triangle is bisected further
  double of_area = 1.0 / 256;    ///< `shortest` where areas are measured
};
constexpr PartLimits kPartLimits;

/// Where a condition is tested on a triangle: its centroid, corners and midpoints of sides.
constexpr int kPlaces = 7;

/// At how many of these places `at` holds.
template <class At>
int places_held(const std::array<Vec3, 3>& t, const At& at) {
  int held = at((t[0] + t[1] + t[2]) / 3) ? 1 : 0;
  for (int k = 0; k < 3; ++k) {
    held += at(t[k]) ? 1 : 0;
    held += at(0.5 * (t[k] + t[(k + 1) % 3])) ? 1 : 0;
  }
  return held;
}

/// Index of a triangle's longest side; side k runs from corner k to the next.
int longest_side(const std::array<Vec3, 3>& t) {
  int longest = 0;
  std::array<double, 3> side{};
  for (int k = 0; k < 3; ++k) {
    side[k] = distance(t[k], t[(k + 1) % 3]);
    if (side[k] > side[longest]) longest = k;
  }
  return longest;
}
double length_of_side(const std::array<Vec3, 3>& t, int k) {
  return distance(t[k], t[(k + 1) % 3]);
}

/// The halves of a triangle, bisected at the midpoint of a side moved onto the surface.
std::array<std::array<Vec3, 3>, 2> halved(const std::array<Vec3, 3>& t, int side,
                                          const Surface& surface) {
  const Vec3 &a = t[side], &b = t[(side + 1) % 3], &c = t[(side + 2) % 3];
  const Vec3 middle = project(surface, 0.5 * (a + b));
  return {{{a, middle, c}, {middle, b, c}}};
}

/// Divides the triangles of a face where a condition changes.
class FaceDivider {
 public:
  FaceDivider(const BoundaryFace& face, const OpenExpression& condition, double length,
              const Run& run)
      : face_(face), holds_(condition), poll_(run) {
    const double diagonal = box_of(face.points).diagonal();
    first_ = kPartLimits.first * diagonal;
    shortest_ = std::fmax(length, kPartLimits.shortest * diagonal);
  }

  /// Appends the parts of the triangle on which the condition holds.
  void add(const std::array<Vec3, 3>& triangle) {
    if (divide(triangle)) part_.push_back(triangle);
  }
  [[nodiscard]] std::vector<std::array<Vec3, 3>> part() && { return std::move(part_); }

 private:
  /// True if the condition holds on all of the triangle, which the caller has to append then;
  /// otherwise the parts on which it holds are appended here.
  bool divide(const std::array<Vec3, 3>& t) {
    poll_();
    const int longest = longest_side(t);
    const double length = length_of_side(t, longest);
    if (length <= first_) {
      const int held = places_held(t, [&](const Vec3& p) { return at(p); });
      if (held == 0) return false;
      if (held == kPlaces) return true;
      if (length <= shortest_) return at((t[0] + t[1] + t[2]) / 3);
    }
    const auto halves = halved(t, longest, face_.surface);
    const std::array<bool, 2> whole{divide(halves[0]), divide(halves[1])};
    // On a plane two whole halves are the same as the triangle; on a curved face they fit better.
    if (whole[0] && whole[1] && face_.surface.kind == Surface::Kind::Plane) return true;
    for (int k = 0; k < 2; ++k)
      if (whole[k]) part_.push_back(halves[k]);
    return false;
  }

  [[nodiscard]] bool at(const Vec3& p) { return holds_(p, outward_normal(face_, p)); }

  const BoundaryFace& face_;
  ConditionTest holds_;
  Polling poll_;
  double first_ = 0, shortest_ = 0;
  std::vector<std::array<Vec3, 3>> part_;
};

/// Measures the part of a face where a condition holds.
class PartMeasure {
 public:
  PartMeasure(const BoundaryFace& face, const PlaceTest& holds, const Run& run)
      : face_(face), holds_(holds), poll_(run) {
    const double diagonal = box_of(face.points).diagonal();
    first_ = kPartLimits.first * diagonal;
    shortest_ = kPartLimits.of_area * diagonal;
  }

  void add(const std::array<Vec3, 3>& t) {
    poll_();
    const int longest = longest_side(t);
    const double length = length_of_side(t, longest);
    if (length <= first_) {
      const int held = places_held(t, [&](const Vec3& p) { return at(p); });
      const double area = triangle_area(t[0], t[1], t[2]);
      const bool even = held == 0 || held == kPlaces;
      if (even || length <= shortest_) {
        all_ += area;
        held_ += even ? (held == 0 ? 0 : area) : cut(t, area);
        return;
      }
    }
    for (const auto& half : halved(t, longest, face_.surface)) add(half);
  }
  [[nodiscard]] double share() const { return all_ > 0 ? held_ / all_ : 0; }

 private:
  [[nodiscard]] bool at(const Vec3& p) const { return holds_(p, outward_normal(face_, p)); }

  /// Where the condition changes between `in`, where it holds, and `out`, where it does not: as a
  /// share of the way from `in`, by bisection.
  [[nodiscard]] double crossing(const Vec3& in, const Vec3& out) const {
    double lo = 0, hi = 1;
    for (int k = 0; k < 20; ++k) {
      const double middle = 0.5 * (lo + hi);
      (at(in + middle * (out - in)) ? lo : hi) = middle;
    }
    return 0.5 * (lo + hi);
  }

  /// Area of the part of a small triangle on which the condition holds, bounded by a straight cut.
  [[nodiscard]] double cut(const std::array<Vec3, 3>& t, double area) const {
    std::array<bool, 3> in{};
    for (int k = 0; k < 3; ++k) in[k] = at(t[k]);
    const auto count = std::ranges::count(in, true);
    if (count == 0 || count == 3) return at((t[0] + t[1] + t[2]) / 3) ? area : 0;
    // One corner is alone on its side of the cut.
    const bool alone = count == 1;
    const auto k = std::ranges::find(in, alone) - in.begin();
    double corner = area;
    for (const auto other : {(k + 1) % 3, (k + 2) % 3})
      corner *= alone ? crossing(t[k], t[other]) : 1 - crossing(t[other], t[k]);
    return alone ? corner : area - corner;
  }

  const BoundaryFace& face_;
  const PlaceTest& holds_;
  Polling poll_;
  double first_ = 0, shortest_ = 0;
  double all_ = 0, held_ = 0;
};

}  // namespace

double area_where(const BoundaryFace& face, const PlaceTest& holds, const Run& run) {
  PartMeasure measure(face, holds, run);
  for (const auto& t : face.triangles)
    measure.add({face.points[t[0]], face.points[t[1]], face.points[t[2]]});
  return measure.share() * face.area;
}

std::vector<std::array<Vec3, 3>> part_where(const BoundaryFace& face,
                                            const OpenExpression& condition, double length,
                                            const Run& run) {
  FaceDivider divider(face, condition, length, run);
  for (const auto& t : face.triangles)
    divider.add({face.points[t[0]], face.points[t[1]], face.points[t[2]]});
  return std::move(divider).part();
}

}  // namespace remeshd
