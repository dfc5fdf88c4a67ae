#include "engine/kernel/border_mesh.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace remeshd::kernel {
namespace {

enum class Inside : std::uint8_t { Unknown, No, Yes };

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<int, K>;
using Faces = CGAL::Constrained_triangulation_face_base_2<
    K, CGAL::Triangulation_face_base_with_info_2<Inside, K>>;
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
  /// Whether each segment has two corners, and no other has the same.
  [[nodiscard]] bool distinct() const {
    return std::ranges::none_of(sorted_, [](const auto& s) { return s[0] == s[1]; }) &&
           std::ranges::adjacent_find(sorted_, [](const auto& a, const auto& b) {
             return a[0] == b[0] && a[1] == b[1];
           }) == sorted_.end();
  }
  [[nodiscard]] bool odd(int a, int b) const {
    const auto it =
        std::ranges::lower_bound(sorted_, std::array{std::min(a, b), std::max(a, b), 0});
    return it != sorted_.end() && (*it)[0] == std::min(a, b) && (*it)[1] == std::max(a, b) &&
           border_.segments[(*it)[2]].uses % 2 == 1;
  }

 private:
  const Border& border_;
  std::vector<std::array<int, 3>> sorted_;
};

/// Whether the side opposite corner i is a segment with an odd number of uses.
bool parts(FaceHandle t, int i, const Segments& segments) {
  return t->is_constrained(i) && segments.odd(t->vertex(Triangulation::cw(i))->info(),
                                              t->vertex(Triangulation::ccw(i))->info());
}

/// Marks as inside what an odd number of segment uses separates from the outside.
void tell_inside(const Triangulation& mesh, const Segments& segments) {
  for (auto t = mesh.all_faces_begin(); t != mesh.all_faces_end(); ++t) t->info() = Inside::Unknown;
  mesh.infinite_face()->info() = Inside::No;
  std::vector<FaceHandle> todo{mesh.infinite_face()};
  while (!todo.empty()) {
    const FaceHandle t = todo.back();
    todo.pop_back();
    for (int i = 0; i < 3; ++i) {
      const FaceHandle next = t->neighbor(i);
      if (next->info() != Inside::Unknown) continue;
      next->info() = (t->info() == Inside::Yes) != parts(t, i, segments) ? Inside::Yes : Inside::No;
      todo.push_back(next);
    }
  }
}

/// Whether inside and outside meet exactly at the segments with an odd number of uses.
bool consistent(const Triangulation& mesh, const Segments& segments) {
  for (auto t = mesh.all_faces_begin(); t != mesh.all_faces_end(); ++t)
    for (int i = 0; i < 3; ++i)
      if ((t->info() != t->neighbor(i)->info()) != parts(t, i, segments)) return false;
  return true;
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

K::Point_2 point2(const Border& border, int corner) {
  const auto& p = border.corners[corner].p;
  return {p[0], p[1]};
}

bool cross(const Border& border, const Border::Segment& s, const Border::Segment& t) {
  const auto at = [&](int corner) { return point2(border, corner); };
  for (const auto& [a, b] : {std::pair(s.a, s.b), std::pair(s.b, s.a)})
    for (const auto& [c, d] : {std::pair(t.a, t.b), std::pair(t.b, t.a)})
      if (a == c)
        return b == d || (CGAL::collinear(at(a), at(b), at(d)) &&
                          CGAL::angle(at(b), at(a), at(d)) == CGAL::ACUTE);
  return CGAL::do_intersect(K::Segment_2(at(s.a), at(s.b)), K::Segment_2(at(t.a), at(t.b)));
}

}  // namespace

std::optional<std::vector<std::array<int, 3>>> mesh_border(
    const Border& border, std::span<const std::array<double, 2>> inner) {
  const Segments segments(border);
  Triangulation mesh;
  if (!segments.distinct() || !build(border, inner, mesh)) return std::nullopt;
  tell_inside(mesh, segments);
  if (!consistent(mesh, segments)) return std::nullopt;
  std::vector<std::array<int, 3>> out;
  for (auto t = mesh.finite_faces_begin(); t != mesh.finite_faces_end(); ++t)
    if (t->info() == Inside::Yes)
      out.push_back({t->vertex(0)->info(), t->vertex(1)->info(), t->vertex(2)->info()});
  return out;
}

std::vector<std::pair<int, int>> crossing_segments(const Border& border) {
  const auto& segments = border.segments;
  std::vector<CGAL::Bbox_2> boxes;
  for (const Border::Segment& s : segments)
    boxes.push_back(point2(border, s.a).bbox() + point2(border, s.b).bbox());
  std::vector<std::pair<int, int>> crossing;
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (std::size_t j = i + 1; j < segments.size(); ++j)
      if (CGAL::do_overlap(boxes[i], boxes[j]) && cross(border, segments[i], segments[j]))
        crossing.emplace_back(static_cast<int>(i), static_cast<int>(j));
  return crossing;
}

}  // namespace remeshd::kernel
