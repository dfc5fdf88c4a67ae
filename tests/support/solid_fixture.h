#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "engine/base/random.h"
#include "engine/base/run.h"
#include "engine/cellular/boundary_model/support.h"
#include "engine/delaunay/delaunay_mesh.h"
#include "engine/mesh/quality.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd::test {

/// A solid with hand-made boundary, and a Delaunay mesh of jittered nodes in it: slivers included.
struct SolidFixture {
  BoundaryModel boundary;
  TetMesh mesh;
  std::vector<Support> supports;
  double volume = 0;  ///< exact

  [[nodiscard]] std::vector<std::uint8_t> all_dirty() const {
    return std::vector<std::uint8_t>(mesh.tets.size(), 1);
  }
  std::int32_t add(const Vec3& p, Support::Kind kind, int entity) {
    mesh.nodes.push_back(p);
    supports.push_back({kind, entity});
    return static_cast<std::int32_t>(mesh.nodes.size()) - 1;
  }
  /// Delaunay mesh of all nodes; keeps the tets for which `keep(centroid)`.
  template <class Keep>
  void triangulate(const Keep& keep) {
    Box box;
    for (const Vec3& p : mesh.nodes) box.add(p);
    std::vector<std::int32_t> all(mesh.nodes.size());
    std::iota(all.begin(), all.end(), 0);
    DelaunayMesh delaunay(box);
    delaunay.insert(mesh.nodes, all, Run{});
    delaunay.for_each_tet([&](const DelaunayMesh::Corners& tet) {
      Vec3 c;
      for (const std::int32_t n : tet) c += 0.25 * mesh.nodes[n];
      if (keep(c)) mesh.tets.push_back(tet);
    });
  }
};

/// Adds a straight edge between two vertices.
inline int add_line(BoundaryModel& b, int start, int end, std::vector<int> faces) {
  const int e = static_cast<int>(b.edges.size());
  const Vec3 p = b.vertices[start].position;
  const Vec3 q = b.vertices[end].position;
  BoundaryEdge edge;
  edge.curve = {Curve::Kind::Line, p, normalised(q - p), 0};
  edge.points = {p, q};
  edge.start = start;
  edge.end = end;
  edge.faces = std::move(faces);
  edge.length = distance(p, q);
  for (const int f : edge.faces) b.faces[f].edges.push_back(e);
  b.vertices[start].edges.push_back(e);
  b.vertices[end].edges.push_back(e);
  b.edges.push_back(std::move(edge));
  return e;
}

/// Box with corners at 0 and `size` in the given frame and about nx nodes along its x edges. Nodes
/// stand on a lattice and are shaken by `jitter` of its step, along the edge or in the face for
/// those on the boundary.
inline SolidFixture make_box(const Vec3& size, int nx, std::uint64_t seed, double jitter = 0.25,
                             const Transform& frame = {}) {
  SolidFixture s;
  s.volume = size.x * size.y * size.z;
  BoundaryModel& b = s.boundary;
  const double step = size.x / nx;
  const std::array<double, 3> length{size.x, size.y, size.z};
  std::array<int, 3> n{};
  for (int k = 0; k < 3; ++k) n[k] = std::max(1, static_cast<int>(std::lround(length[k] / step)));
  const auto at = [&](double i, double j, double k) {
    return frame.apply({size.x * i / n[0], size.y * j / n[1], size.z * k / n[2]});
  };
  // Faces 2k and 2k + 1 lie at the low and the high end of axis k, vertices and edges as numbered
  // by the loops.
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      std::array<Vec3, 3> unit{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
      Vec3 local;
      if (side == 1) local = length[axis] * unit[axis];
      const double sign = side == 1 ? 1 : -1;
      const Vec3 z = frame.rotate(sign * unit[axis]);
      const Vec3 x = frame.rotate(unit[(axis + 1) % 3]);
      BoundaryFace face;
      face.surface.kind = Surface::Kind::Plane;
      face.surface.frame = Transform::frame(x, cross(z, x), z, frame.apply(local));
      face.area = length[(axis + 1) % 3] * length[(axis + 2) % 3];
      b.faces.push_back(face);
    }
  }
  for (int v = 0; v < 8; ++v) {
    const Vec3 p = at((v & 1) != 0 ? n[0] : 0, (v & 2) != 0 ? n[1] : 0, (v & 4) != 0 ? n[2] : 0);
    b.vertices.push_back({p, {}});
    b.bounds.add(p);
  }
  for (int v = 0; v < 8; ++v)
    for (int axis = 0; axis < 3; ++axis)
      if ((v >> axis & 1) == 0) {
        const int p = (axis + 1) % 3;
        const int q = (axis + 2) % 3;
        std::vector<int> faces{2 * p + (v >> p & 1), 2 * q + (v >> q & 1)};
        std::sort(faces.begin(), faces.end());
        add_line(b, v, v | 1 << axis, faces);
      }
  Random random(seed);
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i) {
        const std::array<int, 3> index{i, j, k};
        std::array<double, 3> place{};
        std::vector<int> faces;
        for (int axis = 0; axis < 3; ++axis) {
          const double shake = random.uniform(-jitter, jitter);
          const bool low = index[axis] == 0;
          const bool high = index[axis] == n[axis];
          place[axis] = index[axis] + (low || high ? 0.0 : shake);
          if (low || high) faces.push_back(2 * axis + (high ? 1 : 0));
        }
        const Vec3 p = at(place[0], place[1], place[2]);
        if (faces.empty()) {
          s.add(p, Support::Kind::Interior, -1);
        } else if (faces.size() == 1) {
          s.add(p, Support::Kind::Face, faces[0]);
        } else if (faces.size() == 2) {
          int edge = 0;
          while (b.edges[edge].faces != faces) ++edge;
          s.add(p, Support::Kind::Edge, edge);
        } else {
          const int v = (i > 0 ? 1 : 0) | (j > 0 ? 2 : 0) | (k > 0 ? 4 : 0);
          s.add(b.vertices[v].position, Support::Kind::Vertex, v);
        }
      }
  s.triangulate([](const Vec3&) { return true; });
  return s;
}

/// Cylinder along z (faces: 0 wall, 1 bottom, 2 top; edges: 0 bottom, 1 top circle, no vertex) with
/// about `around` nodes along a circle.
inline SolidFixture make_cylinder(double radius, double height, int around, std::uint64_t seed) {
  constexpr double kPi = std::numbers::pi;
  SolidFixture s;
  s.volume = kPi * radius * radius * height;
  BoundaryModel& b = s.boundary;
  BoundaryFace wall;
  wall.surface.kind = Surface::Kind::Cylinder;
  wall.surface.r1 = radius;
  wall.area = 2 * kPi * radius * height;
  wall.edges = {0, 1};
  BoundaryFace bottom;  // its plane looks up, the material's outside down
  bottom.reversed = true;
  bottom.area = kPi * radius * radius;
  bottom.edges = {0};
  BoundaryFace top;
  top.surface.frame = Transform::translation({0, 0, height});
  top.area = bottom.area;
  top.edges = {1};
  b.faces = {wall, bottom, top};
  for (int e = 0; e < 2; ++e) {
    BoundaryEdge circle;
    const double z = e == 0 ? 0 : height;
    circle.curve = {Curve::Kind::Circle, {0, 0, z}, {0, 0, 1}, radius};
    for (int i = 0; i <= 72; ++i) {
      const double t = 2 * kPi * (i % 72) / 72;
      circle.points.push_back({radius * std::cos(t), radius * std::sin(t), z});
    }
    circle.faces = {0, 1 + e};
    circle.length = 2 * kPi * radius;
    b.edges.push_back(circle);
  }
  b.bounds.add(Vec3{-radius, -radius, 0});
  b.bounds.add(Vec3{radius, radius, height});

  Random random(seed);
  const double step = 2 * kPi * radius / around;
  const int layers = std::max(1, static_cast<int>(std::lround(height / step)));
  const double jitter = 0.2 * step;
  const auto polar = [&](double r, double t, double z) {
    return Vec3{r * std::cos(t), r * std::sin(t), z};
  };
  for (int k = 0; k <= layers; ++k) {
    const double z = height * k / layers;
    const bool cap = k == 0 || k == layers;
    for (int i = 0; i < around; ++i) {
      const double t = 2 * kPi * (i + 0.5 * (k % 2) + random.uniform(-0.2, 0.2)) / around;
      const double dz = random.uniform(-jitter, jitter);
      if (cap)
        s.add(polar(radius, t, z), Support::Kind::Edge, k == 0 ? 0 : 1);
      else
        s.add(polar(radius, t, z + dz), Support::Kind::Face, 0);
    }
    const int cells = static_cast<int>(std::ceil(2 * radius / step));
    for (int j = 0; j <= cells; ++j)
      for (int i = 0; i <= cells; ++i) {
        const Vec3 p{-radius + (i + 0.5 * (k % 2)) * step + random.uniform(-jitter, jitter),
                     -radius + (j + 0.5 * (k % 2)) * step + random.uniform(-jitter, jitter),
                     z + (cap ? 0.0 : random.uniform(-jitter, jitter))};
        if (std::hypot(p.x, p.y) > radius - 0.7 * step) continue;
        s.add(p, cap ? Support::Kind::Face : Support::Kind::Interior, cap ? (k == 0 ? 1 : 2) : -1);
      }
  }
  s.triangulate([](const Vec3&) { return true; });
  return s;
}

}  // namespace remeshd::test
