#include "engine/local_fuse/sewing/cylinder_faces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "engine/base/angle.h"
#include "engine/base/tolerance.h"
#include "engine/kernel/curve_points.h"
#include "engine/local_fuse/sewing/plane_face.h"

namespace remeshd {
namespace {

using kernel::Brep;
using kernel::BrepEdge;
using kernel::BrepFace;

/// Integrals over a region of the cylinder, in its frame, as sums along its border.
struct WallMoments {
  double area = 0, height = 0;        ///< of 1 and of z
  double normal_x = 0, normal_y = 0;  ///< of the outward unit normal's x and y

  /// Adds a part of the border at height z that runs through `angle` (rad) about the axis; `cosine`
  /// and `sine` are the integrals of the angle's cosine and sine along it.
  void add(double z, double radius, double angle, double cosine, double sine) {
    area -= radius * z * angle;
    height -= radius * 0.5 * z * z * angle;
    normal_x -= radius * z * cosine;
    normal_y -= radius * z * sine;
  }
};

/// Edges of a cylinder unrolled into a plane, where plane_faces finds and triangulates the faces.
class Unrolled {
 public:
  Unrolled(const Brep& brep, const Surface& cylinder, double cut)
      : brep_(brep), cylinder_(cylinder), into_(rigid_inverse(cylinder.frame)), cut_(cut) {}

  Tried<std::vector<BrepFace>> faces(std::span<const CylinderUse> uses) {
    flatten(uses);
    for (const CylinderUse& use : uses) add(use);
    std::vector<PlaneEdge> edges;
    for (int e = 0; e < static_cast<int>(source_.size()); ++e) edges.push_back({e, uses_[e]});
    auto faces = plane_faces(flat_, edges, Surface{}, {});
    if (!faces) return faces.why();
    for (BrepFace& face : *faces) roll_up(face);
    return faces;
  }

 private:
  [[nodiscard]] double angle_at(const Vec3& q) const {
    return wrapped(std::atan2(q.y, q.x) - cut_);
  }

  /// Scales heights so that all of them together span no more than an arc of kFaceTurning. So the
  /// triangles stand along the axis and not across it, where they would cut the cylinder short.
  void flatten(std::span<const CylinderUse> uses) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const CylinderUse& use : uses)
      for (const int p : brep_.edges[use.edge].chain) {
        const double z = into_.apply(brep_.points[p]).z;
        low = std::min(low, z);
        high = std::max(high, z);
      }
    flat_height_ = std::min(1.0, kernel::kFaceTurning * cylinder_.r1 / (high - low));
  }

  /// The plane's point for a node. A node at the cut has two, at the angles 0 and kTurn; it is the
  /// one on the side of `from`, the angle of a place on the edge beside it.
  int point(int node, double from) {
    const Vec3 q = into_.apply(brep_.points[node]);
    double angle = angle_at(q);
    const bool at_cut =
        angle < tolerance::kSameDirection || angle > kTurn - tolerance::kSameDirection;
    if (at_cut) angle = from < std::numbers::pi ? 0 : kTurn;
    const auto [it, fresh] = point_.try_emplace(std::pair(node, at_cut && angle > 0),
                                                static_cast<int>(flat_.points.size()));
    if (fresh) {
      flat_.points.push_back({cylinder_.r1 * angle, flat_height_ * q.z, 0});
      node_.push_back(node);
    }
    return it->second;
  }

  void add(const CylinderUse& use) {
    const BrepEdge& edge = brep_.edges[use.edge];
    BrepEdge flat;
    const auto middle = [&](std::size_t i) {
      return angle_at(
          into_.apply(0.5 * (brep_.points[edge.chain[i]] + brep_.points[edge.chain[i + 1]])));
    };
    if (edge.kind == BrepEdge::Kind::Line) {
      const double side = use.ahead ? 0 : kTurn;
      for (const int p : edge.chain) flat.chain.push_back(point(p, side));
    } else {
      for (std::size_t i = 0; i < edge.chain.size(); ++i)
        flat.chain.push_back(point(edge.chain[i], middle(i == 0 ? 0 : i - 1)));
    }
    for (int e = 0; e < static_cast<int>(source_.size()); ++e)
      if (source_[e] == use.edge && flat_.edges[e].chain == flat.chain) {
        ++uses_[e];
        return;
      }
    // Chords alone, for plane_faces to check that the triangles cover what they enclose; the
    // moments of the face itself are taken from the curves, in roll_up.
    flat.kind = BrepEdge::Kind::Other;
    for (std::size_t i = 0; i + 1 < flat.chain.size(); ++i) {
      const Vec3 &p = flat_.points[flat.chain[i]], &q = flat_.points[flat.chain[i + 1]];
      flat.samples.push_back({0.5 * (p + q), q - p});
    }
    flat_.edges.push_back(std::move(flat));
    source_.push_back(use.edge);
    uses_.push_back(1);
  }

  void roll_up(BrepFace& face) const {
    std::vector<std::array<int, 2>> sides;  // of all triangles, directed
    for (const auto& t : face.triangles)
      for (int i = 0; i < 3; ++i) sides.push_back({t[i], t[(i + 1) % 3]});
    std::ranges::sort(sides);
    WallMoments moments;
    for (int& e : face.edges) {
      const std::vector<int>& chain = flat_.edges[e].chain;
      // An edge with the face on both sides is added in both directions, which cancel.
      for (const int sign : {1, -1}) {
        const std::array<int, 2> side =
            sign > 0 ? std::array{chain[0], chain[1]} : std::array{chain[1], chain[0]};
        if (std::ranges::binary_search(sides, side)) add_moments(source_[e], sign, moments);
      }
      e = source_[e];
    }
    std::ranges::sort(face.edges);
    for (auto& triangle : face.triangles)
      for (int& p : triangle) p = node_[p];
    const double r = cylinder_.r1;
    face.area = moments.area;
    face.centroid = cylinder_.frame.apply(
        Vec3{r * moments.normal_x, r * moments.normal_y, moments.height} / moments.area);
    const Vec3 reference = into_.apply(brep_.reference);
    face.swept_volume =
        (r * moments.area - reference.x * moments.normal_x - reference.y * moments.normal_y) / 3;
  }

  void add_moments(int e, double sign, WallMoments& out) const {
    const BrepEdge& edge = brep_.edges[e];
    if (edge.kind == BrepEdge::Kind::Line) return;
    if (edge.kind == BrepEdge::Kind::Other) {
      for (const auto& [p, along] : edge.samples) {
        const Vec3 q = into_.apply(p), d = into_.rotate(along);
        const double r = std::hypot(q.x, q.y), c = q.x / r, s = q.y / r;
        const double angle = sign * (c * d.y - s * d.x) / r;
        out.add(q.z, cylinder_.r1, angle, c * angle, s * angle);
      }
      return;
    }
    const Vec3 q = into_.apply(edge.points.front());
    const double turning = dot(into_.rotate(edge.axis), {0, 0, 1}) > 0 ? 1 : -1;
    const double first = std::atan2(q.y, q.x), angle = turning * edge.length / edge.radius;
    const double last = first + angle;
    out.add(q.z, cylinder_.r1, sign * angle, sign * (std::sin(last) - std::sin(first)),
            sign * (std::cos(first) - std::cos(last)));
  }

  const Brep& brep_;
  const Surface& cylinder_;
  Transform into_;
  double cut_, flat_height_ = 1;
  Brep flat_;
  std::vector<int> node_;                      ///< by point of the plane
  std::map<std::pair<int, bool>, int> point_;  ///< by node, and whether it is the one at kTurn
  std::vector<int> source_, uses_;             ///< by edge of the plane
};

}  // namespace

Tried<std::vector<BrepFace>> cylinder_faces(const Brep& brep, std::span<const CylinderUse> uses,
                                            const Surface& cylinder, double cut) {
  return Unrolled(brep, cylinder, cut).faces(uses);
}

}  // namespace remeshd
