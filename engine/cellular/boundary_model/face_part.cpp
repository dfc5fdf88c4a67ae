#include "engine/cellular/boundary_model/face_part.h"

#include <algorithm>
#include <cmath>

namespace remeshd {

namespace {

struct PartLimits {
  // Lengths of a triangle's longest side, x the diagonal of the box asked for; where areas are
  // measured, of the face's box.
  double first = 1.0 / 16;       ///< longer triangles are bisected before the condition is tested
  double shortest = 1.0 / 1000;  ///< no triangle is bisected further
  double of_area = 1.0 / 256;    ///< instead of `shortest` where areas are measured
  double shortest_told = 1.0 / 4096;  ///< instead of `of_area` where all margins are known
  double linear = 0.003;      ///< x the spread of margins: a smaller deviation counts as linear
  int most_tested = 100'000;  ///< triangles of a face; from then on `of_area` counts everywhere
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

/// Divides the triangles of a face where a test changes.
class FaceDivider {
 public:
  FaceDivider(const Box& box, const BoundaryFace& face, const FaceTest& holds, double length,
              const Run& run)
      : box_(box), face_(face), holds_(holds), poll_(run) {
    const double diagonal = box.diagonal();
    first_ = kPartLimits.first * diagonal;
    shortest_ = std::fmax(length, kPartLimits.shortest * diagonal);
  }

  /// Appends the parts of the triangle on which the test holds.
  void add(const std::array<Vec3, 3>& triangle) {
    if (divide(triangle)) part_.push_back(triangle);
  }
  [[nodiscard]] std::vector<std::array<Vec3, 3>> part() && { return std::move(part_); }

 private:
  /// True if the test holds on all of the triangle, which the caller has to append then;
  /// otherwise the parts on which it holds are appended here.
  bool divide(const std::array<Vec3, 3>& t) {
    poll_();
    if (intersection(box_of(t), box_).empty()) return false;
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

  [[nodiscard]] bool at(const Vec3& p) const { return holds_(p, outward_normal(face_, p)); }

  const Box& box_;
  const BoundaryFace& face_;
  const FaceTest& holds_;
  Polling poll_;
  double first_ = 0, shortest_ = 0;
  std::vector<std::array<Vec3, 3>> part_;
};

/// A triangle of a face with what a condition tells at its places: its corners, the middles of its
/// sides, side k from corner k on, and its centroid.
struct TestedTriangle {
  std::array<Vec3, 3> corners;
  std::array<Held, kPlaces> held;
  double length;  ///< of the longest side

  [[nodiscard]] bool all_alike() const {
    return std::ranges::all_of(held, [&](const Held& h) { return h.holds == held[0].holds; });
  }
  [[nodiscard]] bool margins_are_told() const {
    return std::ranges::all_of(held, [](const Held& h) { return std::isfinite(h.margin); });
  }
  /// The greatest difference of margins: at places no further than `length` from each other.
  [[nodiscard]] double spread() const {
    const auto [least, greatest] = std::ranges::minmax(held, {}, &Held::margin);
    return greatest.margin - least.margin;
  }
  /// Whether the border of the part may run through the triangle although the condition is the same
  /// at all places. No point of the triangle is further than 0.3 x `length` from a place, and over
  /// that distance margins change by about 0.3 x their spread. The test takes the whole spread,
  /// because margins may change faster between the places.
  [[nodiscard]] bool border_may_be_in() const {
    const auto size = [](const Held& h) { return std::fabs(h.margin); };
    return size(std::ranges::min(held, {}, size)) < spread();
  }
  /// Whether margins change linearly, and tell of each place what the condition does.
  [[nodiscard]] bool is_linear() const {
    const double off = kPartLimits.linear * spread();
    const auto at = [&](int k) { return held[k].margin; };
    if (std::fabs(at(6) - (at(0) + at(1) + at(2)) / 3) > off) return false;
    for (int k = 0; k < 3; ++k)
      if (std::fabs(at(3 + k) - 0.5 * (at(k) + at((k + 1) % 3))) > off) return false;
    return std::ranges::all_of(held, [](const Held& h) { return h.holds == (h.margin > 0); });
  }
  /// Share of the triangle where margins that are linear are above 0.
  [[nodiscard]] double share_above() const {
    const auto in = [&](int k) { return held[k].margin > 0; };
    const int count = in(0) + in(1) + in(2);
    if (count == 0 || count == 3) return count == 0 ? 0 : 1;
    const bool alone = count == 1;  // one corner is alone on its side
    int k = 0;
    while (in(k) != alone) ++k;
    double corner = 1;
    for (const int other : {(k + 1) % 3, (k + 2) % 3})
      corner *= held[k].margin / (held[k].margin - held[other].margin);
    return alone ? corner : 1 - corner;
  }
};

/// Measures the part of a face where a condition holds.
class PartMeasure {
 public:
  PartMeasure(const BoundaryFace& face, const PlaceTest& holds, const Run& run)
      : face_(face), holds_(holds), poll_(run), diagonal_(box_of(face.points).diagonal()) {}

  void add(const std::array<Vec3, 3>& t) {
    poll_();
    const int longest = longest_side(t);
    const double length = length_of_side(t, longest);
    if (length <= kPartLimits.first * diagonal_ && measure(tested(t, length))) return;
    for (const auto& half : halved(t, longest, face_.surface)) add(half);
  }
  [[nodiscard]] double share() const { return all_ > 0 ? held_ / all_ : 0; }

 private:
  [[nodiscard]] Held at(const Vec3& p) const { return holds_(p, outward_normal(face_, p)); }

  [[nodiscard]] TestedTriangle tested(const std::array<Vec3, 3>& t, double length) {
    ++tested_;
    TestedTriangle all{.corners = t, .held = {}, .length = length};
    for (int k = 0; k < 3; ++k) {
      all.held[k] = at(t[k]);
      all.held[3 + k] = at(0.5 * (t[k] + t[(k + 1) % 3]));
    }
    all.held[6] = at((t[0] + t[1] + t[2]) / 3);
    return all;
  }

  /// Adds the area of the triangle; false where it has to be bisected before.
  bool measure(const TestedTriangle& t) {
    const auto& [a, b, c] = t.corners;
    const double area = triangle_area(a, b, c);
    const bool told = t.margins_are_told();
    const bool even = t.all_alike() && !(told && t.border_may_be_in());
    // With so many triangles the margins follow no border.
    const bool many = tested_ > kPartLimits.most_tested;
    const double shortest = told && !many ? kPartLimits.shortest_told : kPartLimits.of_area;
    if (even) {
      held_ += t.held[0].holds ? area : 0;
    } else if (told && t.is_linear()) {
      held_ += area * t.share_above();
    } else if (t.length <= shortest * diagonal_) {
      held_ += cut(t.corners, area);
    } else {
      return false;
    }
    all_ += area;
    return true;
  }

  /// Where the condition changes between `in`, where it holds, and `out`, where it does not: as a
  /// share of the way from `in`, by bisection.
  [[nodiscard]] double crossing(const Vec3& in, const Vec3& out) const {
    double lo = 0, hi = 1;
    for (int k = 0; k < 20; ++k) {
      const double middle = 0.5 * (lo + hi);
      (at(in + middle * (out - in)).holds ? lo : hi) = middle;
    }
    return 0.5 * (lo + hi);
  }

  /// Area of the part of a small triangle on which the condition holds, bounded by a straight cut.
  [[nodiscard]] double cut(const std::array<Vec3, 3>& t, double area) const {
    std::array<bool, 3> in{};
    for (int k = 0; k < 3; ++k) in[k] = at(t[k]).holds;
    const auto count = std::ranges::count(in, true);
    if (count == 0 || count == 3) return at((t[0] + t[1] + t[2]) / 3).holds ? area : 0;
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
  double diagonal_;  ///< of the face's box
  int tested_ = 0;   ///< triangles
  double all_ = 0, held_ = 0;
};

}  // namespace

double area_where(const BoundaryFace& face, const PlaceTest& holds, const Run& run) {
  PartMeasure measure(face, holds, run);
  for (const auto& t : face.triangles)
    measure.add({face.points[t[0]], face.points[t[1]], face.points[t[2]]});
  return measure.share() * face.area;
}

std::vector<std::array<Vec3, 3>> part_within(const Box& box, const BoundaryFace& face,
                                             const FaceTest& holds, double length, const Run& run) {
  FaceDivider divider(box, face, holds, length, run);
  for (const auto& t : face.triangles)
    divider.add({face.points[t[0]], face.points[t[1]], face.points[t[2]]});
  return std::move(divider).part();
}

std::vector<std::array<Vec3, 3>> part_where(const BoundaryFace& face,
                                            const OpenExpression& condition, double length,
                                            const Run& run) {
  ConditionTest test(condition);
  return part_within(
      box_of(face.points), face, [&](const Vec3& p, const Vec3& n) { return test(p, n); }, length,
      run);
}

}  // namespace remeshd
