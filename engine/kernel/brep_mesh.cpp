#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Message_ProgressRange.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "engine/base/error.h"
#include "engine/kernel/brep_shapes.h"

namespace remeshd::kernel {
namespace {

// Kernel units: a model's diagonal is 128 to 256 of them.
// rad; facets of a round face turn by half of this. The second is for where the first fails; a
// third and finer one would take seconds on a torus.
constexpr std::array<double, 2> kMeshAngles{0.24, 0.1};
constexpr double kMeshDeflection = 0.5;  // far above what the angle asks for
constexpr double kMeshMinimum = 1e-3;    // else small holes are meshed as triangles

void mesh(const TopoDS_Shape& shape, double angle, const Message_ProgressRange& range) {
  IMeshTools_Parameters parameters;
  parameters.Angle = angle;
  parameters.Deflection = kMeshDeflection;
  parameters.MinSize = kMeshMinimum;
  parameters.InParallel = false;
  BRepMesh_IncrementalMesh(shape, parameters, range);
}

/// Numbers the nodes of all faces' triangulations so that those on a shared edge are one.
class NodeNumbers {
 public:
  explicit NodeNumbers(Brep& brep) : brep_(brep), of_edge_(brep.edges.size()) {
    brep.points.clear();
    for (const BrepVertex& vertex : brep.vertices) brep.points.push_back(vertex.position);
    for (BrepFace& face : brep.faces) face.triangles.clear();
  }

  /// False where a face has no sound triangulation.
  bool add_all() {
    for (bad_ = 0; bad_ < static_cast<int>(brep_.faces.size()); ++bad_)
      if (!add_face(bad_,
                    TopoDS::Face(shape_of(brep_, Element::Face, bad_).Oriented(TopAbs_FORWARD))) ||
          !sound(brep_.faces[bad_]))
        return false;
    return apart();
  }
  /// The first without one.
  [[nodiscard]] int bad_face() const { return bad_; }

 private:
  bool add_face(int index, const TopoDS_Face& face) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
    if (mesh.IsNull()) return false;
    std::vector<int> node(static_cast<std::size_t>(mesh->NbNodes()) + 1, -1);

    // Once per use of an edge; a seam has two polygons on the same face.
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      const Handle(Poly_PolygonOnTriangulation) polygon =
          BRep_Tool::PolygonOnTriangulation(edge, mesh, location);
      if (polygon.IsNull()) return false;
      const int e = index_of(brep_, Element::Edge, edge);
      const int n = polygon->NbNodes();
      if (e < 0) {  // degenerate: a pole or an apex
        const int v = index_of(brep_, Element::Vertex, TopExp::FirstVertex(edge));
        for (int i = 1; i <= n; ++i) node[polygon->Node(i)] = v;
        continue;
      }
      std::vector<int>& numbers = of_edge_[e];
      if (numbers.empty()) {
        numbers.push_back(brep_.edges[e].vertices[0]);
        for (int i = 2; i < n; ++i)
          numbers.push_back(add(mesh->Node(polygon->Node(i)).Transformed(location)));
        numbers.push_back(brep_.edges[e].vertices[1]);
      }
      if (static_cast<int>(numbers.size()) != n) return false;
      for (int i = 1; i <= n; ++i) node[polygon->Node(i)] = numbers[i - 1];
    }
    for (int i = 1; i <= mesh->NbNodes(); ++i)
      if (node[i] < 0) node[i] = add(mesh->Node(i).Transformed(location));

    BrepFace& out = brep_.faces[index];
    for (int i = 1; i <= mesh->NbTriangles(); ++i) {
      int a = 0, b = 0, c = 0;
      mesh->Triangle(i).Get(a, b, c);
      const std::array<int, 3> triangle{node[a], node[b], node[c]};
      if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
        out.triangles.push_back(triangle);
    }
    return true;
  }

  /// Whether the triangles of each face cover it once: no half-edge twice, and those without a
  /// partner are the segments of its edges, all of them. Where two edges nearly touch their
  /// polylines may cross, and the CAD kernel then leaves out or doubles triangles without a word.
  [[nodiscard]] bool sound(const BrepFace& face) const {
    std::set<std::array<int, 2>> half_edges;
    for (const auto& t : face.triangles)
      for (int i = 0; i < 3; ++i)
        if (!half_edges.insert({t[i], t[(i + 1) % 3]}).second) return false;
    std::set<std::array<int, 2>> rim;
    for (const auto& [a, b] : half_edges)
      if (!half_edges.contains({b, a})) rim.insert({std::min(a, b), std::max(a, b)});
    std::size_t segments = 0;
    for (const int e : face.edges) {
      if (std::ranges::count(face.edges, e) != 1) continue;  // a seam has the face on both sides
      for (std::size_t i = 0; i + 1 < of_edge_[e].size(); ++i) {
        const int a = of_edge_[e][i], b = of_edge_[e][i + 1];
        if (!rim.contains({std::min(a, b), std::max(a, b)})) return false;
        ++segments;
      }
    }
    return segments == rim.size();
  }

  /// Whether no two faces have a triangle in common, as a shallow cap and the disc below it may.
  [[nodiscard]] bool apart() {
    std::set<std::array<int, 3>> all;
    for (bad_ = 0; bad_ < static_cast<int>(brep_.faces.size()); ++bad_)
      for (std::array<int, 3> t : brep_.faces[bad_].triangles) {
        std::ranges::sort(t);
        if (!all.insert(t).second) return false;
      }
    return true;
  }

  int add(const gp_Pnt& p) {
    brep_.points.push_back(Vec3{p.X(), p.Y(), p.Z()});
    return static_cast<int>(brep_.points.size()) - 1;
  }

  Brep& brep_;
  std::vector<std::vector<int>> of_edge_;
  int bad_ = 0;
};

/// A point of a face for people to look at: of its edges' points the nearest to its centroid, which
/// may lie off the face.
Vec3 place_on(const Brep& brep, int face) {
  Vec3 best = brep.faces[face].centroid;
  double nearest = HUGE_VAL;
  for (const int e : brep.faces[face].edges)
    for (const Vec3& p : brep.edges[e].points)
      if (const double d = distance(p, brep.faces[face].centroid); d < nearest) {
        nearest = d;
        best = p;
      }
  return best;
}

}  // namespace

void triangulate(Brep& brep, const TopoDS_Shape& shape, double scale, const Run& run) {
  int bad = 0;
  for (const double angle : kMeshAngles) {
    if (angle != kMeshAngles.front()) BRepTools::Clean(shape);
    with_progress(run, [&](const Message_ProgressRange& range) { mesh(shape, angle, range); });
    NodeNumbers numbers(brep);
    if (numbers.add_all()) return;
    bad = numbers.bad_face();
  }
  throw error::kernel_failure("a face could not be triangulated", place_on(brep, bad) / scale);
}

}  // namespace remeshd::kernel
