#include "engine/local_fuse/sewing/plane_face.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unordered_map>

#include "engine/kernel/border_mesh.h"
#include "engine/kernel/curve_points.h"

namespace remeshd {
namespace {

using kernel::Border;
using kernel::Brep;
using kernel::BrepEdge;
using kernel::BrepFace;

constexpr double kArc = 0.5;  // rad: longest part of an arc that the rule below integrates at once

/// Area and first moment of a region about an origin in its plane, as sums over its border: of the
/// triangles between the origin and each step along the border.
struct Moments {
  double area = 0;
  Vec3 moment;

  /// Adds the step `along` the border at p, which is relative to the origin.
  void add(const Vec3& p, const Vec3& along, const Vec3& normal) {
    const double fan = 0.5 * dot(cross(p, along), normal);
    area += fan;
    moment += (2.0 / 3 * fan) * p;
  }
};

/// Gauss's rule of five points for [-1, 1], weights for a length of 1.
constexpr std::array<std::array<double, 2>, 5> kRule{{{-0.9061798459386640, 0.1184634425280945},
                                                      {-0.5384693101056831, 0.2393143352496832},
                                                      {0, 64.0 / 225},
                                                      {0.5384693101056831, 0.2393143352496832},
                                                      {0.9061798459386640, 0.1184634425280945}}};

void add_circle(const BrepEdge& edge, const Vec3& origin, double sign, const Vec3& normal,
                Moments& out) {
  if (edge.vertices[0] == edge.vertices[1]) {  // all round
    const double area =
        sign * std::copysign(std::numbers::pi, dot(edge.axis, normal)) * edge.radius * edge.radius;
    out.area += area;
    out.moment += area * (edge.centre - origin);
    return;
  }
  const Vec3 start = edge.points.front() - edge.centre;
  const Vec3 u = normalised(start - dot(start, edge.axis) * edge.axis);
  const Vec3 v = cross(edge.axis, u);
  const double angle = edge.length / edge.radius;
  const int parts = std::max(1, static_cast<int>(std::ceil(angle / kArc)));
  const double step = angle / parts;
  for (int k = 0; k < parts; ++k)
    for (const auto& [x, weight] : kRule) {
      const double t = step * (k + 0.5 + 0.5 * x), c = std::cos(t), s = std::sin(t);
      out.add(edge.centre - origin + edge.radius * (c * u + s * v),
              sign * step * weight * edge.radius * (c * v - s * u), normal);
    }
}

/// Adds an edge, forward where `sign` is 1.
void add_edge(const BrepEdge& edge, const Vec3& origin, double sign, const Vec3& normal,
              Moments& out) {
  if (edge.kind == BrepEdge::Kind::Circle) return add_circle(edge, origin, sign, normal, out);
  if (edge.kind == BrepEdge::Kind::Other) {
    for (const auto& [p, along] : edge.samples) out.add(p - origin, sign * along, normal);
    return;
  }
  const Vec3 a = edge.points.front(), along = edge.points.back() - a;
  for (const auto& [x, weight] : kRule)
    out.add(a - origin + (0.5 + 0.5 * x) * along, sign * weight * along, normal);
}

/// A hash table from directed pairs of nodes to a number: the triangle on their left, or the edge
/// whose polyline has them. Written for speed: faces may have tens of thousands of triangles.
class HalfEdges {
 public:
  explicit HalfEdges(std::size_t triangles)
      : mask_(std::bit_ceil(6 * triangles + 64) - 1), slots_(mask_ + 1, {kFree, -1}) {}

  /// False where the pair is there already.
  bool add(int a, int b, int value) {
    Slot& slot = at(a, b);
    if (slot.key != kFree) return false;
    slot = {key(a, b), value};
    return true;
  }
  /// -1 where there is none.
  [[nodiscard]] int find(int a, int b) const {
    return const_cast<HalfEdges*>(this)->at(a, b).value;  // NOLINT: the table is not changed
  }

 private:
  struct Slot {
    std::uint64_t key;
    int value;
  };
  static constexpr std::uint64_t kFree = ~std::uint64_t{0};
  static std::uint64_t key(int a, int b) {
    return static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint32_t>(b);
  }
  Slot& at(int a, int b) {
    const std::uint64_t k = key(a, b);
    std::size_t i = (k * 0x9E3779B97F4A7C15ULL) >> 20 & mask_;
    while (slots_[i].key != kFree && slots_[i].key != k) i = (i + 1) & mask_;
    return slots_[i];
  }

  std::size_t mask_;
  std::vector<Slot> slots_;
};

/// A part of an edge's polyline, by nodes.
struct Segment {
  int a, b, edge, index, uses;
};

/// The border of what the known triangles leave open: the sides on their rim, and the segments that
/// lack a triangle on one side or both.
class OpenBorder {
 public:
  OpenBorder(const Brep& brep, const Surface& plane)
      : brep_(brep), to_plane_(rigid_inverse(plane.frame)) {}

  void add(int a, int b, int uses) {
    const int i = static_cast<int>(border_.segments.size());
    border_.segments.push_back({corner(a), corner(b), i, 0, uses});
  }
  [[nodiscard]] const Border& border() const { return border_; }
  [[nodiscard]] int node(int corner) const { return border_.corners[corner].node; }

 private:
  int corner(int node) {
    const auto [it, fresh] = corner_of_.try_emplace(node, static_cast<int>(border_.corners.size()));
    if (fresh) {
      const Vec3 p = to_plane_.apply(brep_.points[node]);
      border_.corners.push_back({{p.x, p.y}, node});
    }
    return it->second;
  }

  const Brep& brep_;
  Transform to_plane_;
  Border border_;
  std::unordered_map<int, int> corner_of_;
};

/// The triangles of the region, known and added, and its connected parts.
class Region {
 public:
  Region(const Brep& brep, const std::vector<PlaneEdge>& edges, const Triangles& known)
      : triangles_(known) {
    for (const auto& [e, uses] : edges) {
      const std::vector<int>& chain = brep.edges[e].chain;
      for (int i = 0; i + 1 < static_cast<int>(chain.size()); ++i)
        segments_.push_back({chain[i], chain[i + 1], e, i, uses});
    }
  }

  /// Adds the triangles that are missing.
  Tried<void> fill(const Brep& brep, const Surface& plane) {
    HalfEdges left(triangles_.size()), of_segment(segments_.size());
    for (int t = 0; t < static_cast<int>(triangles_.size()); ++t)
      for (int i = 0; i < 3; ++i)
        if (!left.add(triangles_[t][i], triangles_[t][(i + 1) % 3], t)) return overlap();
    OpenBorder open(brep, plane);
    for (const auto& [a, b, edge, index, uses] : segments_) {
      if (!of_segment.add(a, b, edge) || !of_segment.add(b, a, edge))
        return GaveUp{"plane_face", "two edges share a segment of their polylines"};
      const int missing = uses - (left.find(a, b) >= 0 ? 1 : 0) - (left.find(b, a) >= 0 ? 1 : 0);
      if (missing < 0)
        return GaveUp{"plane_face", "known triangles lie on both sides of an edge of the border"};
      if (missing > 0) open.add(a, b, missing);
    }
    for (const auto& t : triangles_)
      for (int i = 0; i < 3; ++i) {
        const int a = t[i], b = t[(i + 1) % 3];
        if (left.find(b, a) < 0 && of_segment.find(a, b) < 0) open.add(a, b, 1);
      }
    if (open.border().segments.empty()) return {};
    const auto added = kernel::mesh_border(open.border(), {});
    if (!added)
      return GaveUp{"plane_face", "the border does not close, or crosses or touches itself"};
    for (const auto& t : *added)
      triangles_.push_back({open.node(t[0]), open.node(t[1]), open.node(t[2])});
    return {};
  }

  /// Finds the connected parts, which segments separate, and for each segment the parts on its left
  /// and right.
  Tried<void> divide() {
    HalfEdges left(triangles_.size()), of_segment(segments_.size());
    for (int t = 0; t < static_cast<int>(triangles_.size()); ++t)
      for (int i = 0; i < 3; ++i)
        if (!left.add(triangles_[t][i], triangles_[t][(i + 1) % 3], t)) return overlap();
    for (const Segment& s : segments_) {
      of_segment.add(s.a, s.b, s.edge);
      of_segment.add(s.b, s.a, s.edge);
    }
    part_of_.assign(triangles_.size(), -1);
    for (int first = 0; first < static_cast<int>(triangles_.size()); ++first) {
      if (part_of_[first] >= 0) continue;
      std::vector<int> todo{first};
      part_of_[first] = parts_;
      while (!todo.empty()) {
        const auto t = triangles_[todo.back()];
        todo.pop_back();
        for (int i = 0; i < 3; ++i) {
          const int a = t[i], b = t[(i + 1) % 3];
          if (of_segment.find(a, b) >= 0) continue;
          const int next = left.find(b, a);
          if (next < 0) return GaveUp{"plane_face", "a triangle has no neighbour where no edge is"};
          if (part_of_[next] >= 0) continue;
          part_of_[next] = parts_;
          todo.push_back(next);
        }
      }
      ++parts_;
    }
    for (const Segment& s : segments_) {
      const int forward = left.find(s.a, s.b), back = left.find(s.b, s.a);
      sides_.push_back({forward < 0 ? -1 : part_of_[forward], back < 0 ? -1 : part_of_[back]});
      if ((forward >= 0 ? 1 : 0) + (back >= 0 ? 1 : 0) != s.uses)
        return GaveUp{"plane_face", "an edge has triangles on fewer or more sides than the region"};
    }
    return {};
  }

  [[nodiscard]] std::vector<BrepFace> faces() const {
    std::vector<BrepFace> faces(parts_);
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      faces[part_of_[t]].triangles.push_back(triangles_[t]);
    return faces;
  }
  /// Calls visit(edge, part, sign) once for each use of an edge; `sign`: 1 where the part lies on
  /// the edge's left, -1 on its right.
  template <typename Visit>
  void each_use(Visit visit) const {
    for (std::size_t k = 0; k < segments_.size(); ++k)
      if (segments_[k].index == 0)
        for (const int side : {0, 1})
          if (sides_[k][side] >= 0) visit(segments_[k].edge, sides_[k][side], side == 0 ? 1 : -1);
  }

 private:
  static GaveUp overlap() {
    return {"plane_face", "two triangles lie on the same side of a segment"};
  }

  Triangles triangles_;
  std::vector<Segment> segments_;
  std::vector<int> part_of_;  ///< by triangle
  int parts_ = 0;
  std::vector<std::array<int, 2>> sides_;  ///< by segment: parts on its left and right; -1: none
};

}  // namespace

Tried<std::vector<BrepFace>> plane_faces(const Brep& brep, const std::vector<PlaneEdge>& edges,
                                         const Surface& plane, const Triangles& known) {
  Region region(brep, edges, known);
  if (const auto filled = region.fill(brep, plane); !filled) return filled.why();
  if (const auto divided = region.divide(); !divided) return divided.why();
  const Vec3 n = plane.frame.rotate({0, 0, 1});
  std::vector<BrepFace> faces = region.faces();
  std::vector<Moments> moments(faces.size());
  std::vector<Vec3> origins;
  for (const BrepFace& face : faces) origins.push_back(brep.points[face.triangles.front()[0]]);
  region.each_use([&](int edge, int part, double sign) {
    faces[part].edges.push_back(edge);
    add_edge(brep.edges[edge], origins[part], sign, n, moments[part]);
  });
  for (std::size_t r = 0; r < faces.size(); ++r) {
    BrepFace& face = faces[r];
    double meshed = 0;
    for (const auto& [a, b, c] : face.triangles)
      meshed +=
          0.5 * dot(cross(brep.points[b] - brep.points[a], brep.points[c] - brep.points[a]), n);
    if (!(std::fabs(meshed - moments[r].area) <= kernel::kAreaError * meshed))
      return GaveUp{"plane_face", "the triangles do not have the area that the edges enclose"};
    std::ranges::sort(face.edges);
    face.cells = {0, -1};
    face.area = moments[r].area;
    face.centroid = origins[r] + moments[r].moment / face.area;
    face.swept_volume = face.area * dot(plane.frame.apply({0, 0, 0}) - brep.reference, n) / 3;
  }
  return faces;
}

}  // namespace remeshd
