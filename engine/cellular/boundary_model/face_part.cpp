#include "engine/cellular/boundary_model/face_part.h"

#include <algorithm>
#include <cmath>

namespace remeshd {

namespace {

struct PartLimits {
  double first = 1.0 / 16;       ///< of the face's box: no triangle is longer where it is asked
  double shortest = 1.0 / 1000;  ///< of it: no triangle is divided further
};
constexpr PartLimits kPartLimits;

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

  /// Appends what of the triangle the condition holds on.
  void add(const std::array<Vec3, 3>& triangle) {
    if (divide(triangle)) part_.push_back(triangle);
  }
  [[nodiscard]] std::vector<std::array<Vec3, 3>> part() && { return std::move(part_); }

 private:
  /// True if the condition holds on all of the triangle, which is then left to the caller; what it
  /// holds on of others is appended.
  bool divide(const std::array<Vec3, 3>& t) {
    poll_();
    int longest = 0;
    std::array<double, 3> side{};
    for (int k = 0; k < 3; ++k) {
      side[k] = distance(t[k], t[(k + 1) % 3]);
      if (side[k] > side[longest]) longest = k;
    }
    if (side[longest] <= first_) {
      const int held = places_held(t);
      if (held == 0) return false;
      if (held == kPlaces) return true;
      if (side[longest] <= shortest_) return at((t[0] + t[1] + t[2]) / 3);
    }
    const Vec3 &a = t[longest], &b = t[(longest + 1) % 3], &c = t[(longest + 2) % 3];
    const Vec3 middle = project(face_.surface, 0.5 * (a + b));
    const std::array<std::array<Vec3, 3>, 2> halves{{{a, middle, c}, {middle, b, c}}};
    const std::array<bool, 2> whole{divide(halves[0]), divide(halves[1])};
    // Halves of a plane make the whole again; those of a curved face lie nearer to it.
    if (whole[0] && whole[1] && face_.surface.kind == Surface::Kind::Plane) return true;
    for (int k = 0; k < 2; ++k)
      if (whole[k]) part_.push_back(halves[k]);
    return false;
  }

  static constexpr int kPlaces = 7;
  [[nodiscard]] int places_held(const std::array<Vec3, 3>& t) {
    int held = at((t[0] + t[1] + t[2]) / 3) ? 1 : 0;
    for (int k = 0; k < 3; ++k) {
      held += at(t[k]) ? 1 : 0;
      held += at(0.5 * (t[k] + t[(k + 1) % 3])) ? 1 : 0;
    }
    return held;
  }
  [[nodiscard]] bool at(const Vec3& p) { return holds_(p, outward_normal(face_, p)); }

  const BoundaryFace& face_;
  ConditionTest holds_;
  Polling poll_;
  double first_ = 0, shortest_ = 0;
  std::vector<std::array<Vec3, 3>> part_;
};

}  // namespace

std::vector<std::array<Vec3, 3>> part_where(const BoundaryFace& face,
                                            const OpenExpression& condition, double length,
                                            const Run& run) {
  FaceDivider divider(face, condition, length, run);
  for (const auto& t : face.triangles)
    divider.add({face.points[t[0]], face.points[t[1]], face.points[t[2]]});
  return std::move(divider).part();
}

}  // namespace remeshd
