#include "engine/kernel/border_mesh.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cstdint>

namespace remeshd::kernel {
namespace {

struct FaceInfo {
  std::int8_t inside = -1;  ///< -1: not known yet
  int region = -1;
};

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<int, K>;
using Faces = CGAL::Constrained_triangulation_face_base_2<
    K, CGAL::Triangulation_face_base_with_info_2<FaceInfo, K>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    K, CGAL::Triangulation_data_structure_2<Vertices, Faces>>;
using FaceHandle = Triangulation::Face_handle;

/// Finds segments by their corners.
class Segments {
 public:
  explicit Segments(const Border& border) : border_(border) {
    for (int i = 0; i < static_cast<int>(border.segments.size()); ++i) {
      const Border::Segment& s = border.segments[i];
      sorted_.push_back({std::min(s.a, s.b), std::max(s.a, s.b), i});
    }
    std::ranges::sort(sorted_);
  }
  /// Whether no pair of corners is a segment of two edges.
  [[nodiscard]] bool distinct() const {
    return std::ranges::adjacent_find(sorted_, [](const auto& a, const auto& b) {
             return a[0] == b[0] && a[1] == b[1];
           }) == sorted_.end();
  }
  /// -1 where these corners are of none.
  [[nodiscard]] int between(int a, int b) const {
    const auto it =
        std::ranges::lower_bound(sorted_, std::array{std::min(a, b), std::max(a, b), 0});
    return it != sorted_.end() && (*it)[0] == std::min(a, b) && (*it)[1] == std::max(a, b)
               ? (*it)[2]
               : -1;
  }
  [[nodiscard]] const Border::Segment& operator[](int segment) const {
    return border_.segments[segment];
  }

 private:
  const Border& border_;
  std::vector<std::array<int, 3>> sorted_;
};

/// The segment opposite of corner i, -1 if that is none.
int segment_at(FaceHandle t, int i, const Segments& segments) {
  return t->is_constrained(i) ? segments.between(t->vertex(Triangulation::cw(i))->info(),
                                                 t->vertex(Triangulation::ccw(i))->info())
                              : -1;
}

bool parts(FaceHandle t, int i, const Segments& segments) {
  const int s = segment_at(t, i, segments);
  return s >= 0 && segments[s].uses % 2 == 1;
}

/// Inside is what an odd number of segments parts from the outside.
void tell_inside(const Triangulation& mesh, const Segments& segments) {
  mesh.infinite_face()->info().inside = 0;
  std::vector<FaceHandle> todo{mesh.infinite_face()};
  while (!todo.empty()) {
    const FaceHandle t = todo.back();
    todo.pop_back();
    for (int i = 0; i < 3; ++i) {
      const FaceHandle next = t->neighbor(i);
      if (next->info().inside >= 0) continue;
      next->info().inside = (t->info().inside == 1) != parts(t, i, segments) ? 1 : 0;
      todo.push_back(next);
    }
  }
}

/// Whether inside and outside are told apart by the segments and nothing else.
bool consistent(const Triangulation& mesh, const Segments& segments) {
  for (auto t = mesh.all_faces_begin(); t != mesh.all_faces_end(); ++t)
    for (int i = 0; i < 3; ++i)
      if ((t->info().inside != t->neighbor(i)->info().inside) != parts(t, i, segments))
        return false;
  return true;
}

void number_region(FaceHandle first, int region) {
  first->info().region = region;
  std::vector<FaceHandle> todo{first};
  while (!todo.empty()) {
    const FaceHandle t = todo.back();
    todo.pop_back();
    for (int i = 0; i < 3; ++i) {
      const FaceHandle next = t->neighbor(i);
      if (t->is_constrained(i) || next->info().region >= 0) continue;
      next->info().region = region;
      todo.push_back(next);
    }
  }
}

bool build(const Border& border, std::span<const std::array<double, 2>> inner,
           Triangulation& mesh) {
  std::vector<Triangulation::Vertex_handle> handles;
  const auto insert = [&](const std::array<double, 2>& p) {
    const FaceHandle near = handles.empty() ? FaceHandle() : handles.back()->face();
    const auto before = mesh.number_of_vertices();
    handles.push_back(mesh.insert({p[0], p[1]}, near));
    handles.back()->info() = static_cast<int>(handles.size()) - 1;
    return mesh.number_of_vertices() == before + 1;
  };
  for (const Border::Corner& corner : border.corners)
    if (!insert(corner.p)) return false;
  try {
    for (const Border::Segment& s : border.segments)
      mesh.insert_constraint(handles[s.a], handles[s.b]);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return false;
  }
  if (mesh.number_of_vertices() != border.corners.size() || mesh.dimension() < 2) return false;
  return std::ranges::all_of(inner, insert);
}

}  // namespace

std::optional<BorderMesh> mesh_border(const Border& border,
                                      std::span<const std::array<double, 2>> inner) {
  const Segments segments(border);
  Triangulation mesh;
  if (!segments.distinct() || !build(border, inner, mesh)) return std::nullopt;
  tell_inside(mesh, segments);
  if (!consistent(mesh, segments)) return std::nullopt;
  BorderMesh out;
  out.sides.assign(border.segments.size(), {-1, -1});
  for (auto t = mesh.finite_faces_begin(); t != mesh.finite_faces_end(); ++t) {
    if (t->info().inside != 1) continue;
    if (t->info().region < 0) number_region(t, out.regions++);
    out.triangles.push_back(
        {{t->vertex(0)->info(), t->vertex(1)->info(), t->vertex(2)->info()}, t->info().region});
    for (int i = 0; i < 3; ++i)
      if (const int s = segment_at(t, i, segments); s >= 0) {
        const bool forward = t->vertex(Triangulation::ccw(i))->info() == border.segments[s].a;
        out.sides[s][forward ? 0 : 1] = t->info().region;
      }
  }
  return out;
}

}  // namespace remeshd::kernel
