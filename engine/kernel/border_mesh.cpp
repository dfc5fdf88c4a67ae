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

/// How often each pair of corners is a segment, in order of the pairs.
class Uses {
 public:
  explicit Uses(const Border& border) {
    for (const Border::Segment& s : border.segments)
      uses_.push_back({std::min(s.a, s.b), std::max(s.a, s.b), s.uses});
    std::ranges::sort(uses_);
  }
  /// Whether no pair is a segment of two edges.
  [[nodiscard]] bool distinct() const {
    return std::ranges::adjacent_find(uses_, [](const auto& a, const auto& b) {
             return a[0] == b[0] && a[1] == b[1];
           }) == uses_.end();
  }
  [[nodiscard]] bool odd(int a, int b) const {
    const auto it = std::ranges::lower_bound(
        uses_, std::array{std::min(a, b), std::max(a, b), std::numeric_limits<int>::min()});
    return it != uses_.end() && (*it)[0] == std::min(a, b) && (*it)[1] == std::max(a, b) &&
           (*it)[2] % 2 == 1;
  }

 private:
  std::vector<std::array<int, 3>> uses_;
};

bool parts(FaceHandle t, int i, const Uses& uses) {
  return t->is_constrained(i) && uses.odd(t->vertex(Triangulation::cw(i))->info(),
                                          t->vertex(Triangulation::ccw(i))->info());
}

/// Inside is what an odd number of segments parts from the outside.
void tell_inside(const Triangulation& mesh, const Uses& uses) {
  mesh.infinite_face()->info().inside = 0;
  std::vector<FaceHandle> todo{mesh.infinite_face()};
  while (!todo.empty()) {
    const FaceHandle t = todo.back();
    todo.pop_back();
    for (int i = 0; i < 3; ++i) {
      const FaceHandle next = t->neighbor(i);
      if (next->info().inside >= 0) continue;
      next->info().inside = (t->info().inside == 1) != parts(t, i, uses) ? 1 : 0;
      todo.push_back(next);
    }
  }
}

/// Whether inside and outside are told apart by the segments and nothing else.
bool consistent(const Triangulation& mesh, const Uses& uses) {
  for (auto t = mesh.all_faces_begin(); t != mesh.all_faces_end(); ++t)
    for (int i = 0; i < 3; ++i)
      if ((t->info().inside != t->neighbor(i)->info().inside) != parts(t, i, uses)) return false;
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

std::optional<std::vector<BorderTriangle>> mesh_border(
    const Border& border, std::span<const std::array<double, 2>> inner) {
  const Uses uses(border);
  Triangulation mesh;
  if (!uses.distinct() || !build(border, inner, mesh)) return std::nullopt;
  tell_inside(mesh, uses);
  if (!consistent(mesh, uses)) return std::nullopt;
  std::vector<BorderTriangle> out;
  int regions = 0;
  for (auto t = mesh.finite_faces_begin(); t != mesh.finite_faces_end(); ++t) {
    if (t->info().inside != 1) continue;
    if (t->info().region < 0) number_region(t, regions++);
    out.push_back(
        {{t->vertex(0)->info(), t->vertex(1)->info(), t->vertex(2)->info()}, t->info().region});
  }
  return out;
}

}  // namespace remeshd::kernel
