#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include "engine/base/error.h"
#include "engine/kernel/brep_shapes.h"

namespace remeshd::kernel {
namespace {

// Kernel units: a model's diagonal is 128 to 256 of them.
constexpr double kMeshAngle = 0.24;      // rad; facets of a round face turn by half of this
constexpr double kMeshDeflection = 0.5;  // far above what the angle asks for
constexpr double kMeshMinimum = 1e-3;    // else small holes are meshed as triangles

void mesh(const TopoDS_Shape& shape) {
  IMeshTools_Parameters parameters;
  parameters.Angle = kMeshAngle;
  parameters.Deflection = kMeshDeflection;
  parameters.MinSize = kMeshMinimum;
  parameters.InParallel = false;
  BRepMesh_IncrementalMesh(shape, parameters);
}

/// Numbers the nodes of all faces' triangulations so that those on a shared edge are one.
class NodeNumbers {
 public:
  explicit NodeNumbers(Brep& brep) : brep_(brep), of_edge_(brep.edges.size()) {
    for (const BrepVertex& vertex : brep.vertices) brep.points.push_back(vertex.position);
  }

  void add_face(int index, const TopoDS_Face& face) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
    if (mesh.IsNull()) throw error::kernel_failure("a face could not be triangulated");
    std::vector<int> node(static_cast<std::size_t>(mesh->NbNodes()) + 1, -1);

    // Once per use of an edge; a seam has two polygons on the same face.
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      const Handle(Poly_PolygonOnTriangulation) polygon =
          BRep_Tool::PolygonOnTriangulation(edge, mesh, location);
      if (polygon.IsNull()) throw error::kernel_failure("an edge could not be triangulated");
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
      if (static_cast<int>(numbers.size()) != n)
        throw error::kernel_failure("two faces triangulate their edge differently");
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
  }

 private:
  int add(const gp_Pnt& p) {
    brep_.points.push_back(Vec3{p.X(), p.Y(), p.Z()});
    return static_cast<int>(brep_.points.size()) - 1;
  }

  Brep& brep_;
  std::vector<std::vector<int>> of_edge_;
};

}  // namespace

void triangulate(Brep& brep, const TopoDS_Shape& shape) {
  mesh(shape);
  NodeNumbers nodes(brep);
  for (int f = 0; f < static_cast<int>(brep.faces.size()); ++f)
    nodes.add_face(f, TopoDS::Face(shape_of(brep, Element::Face, f).Oriented(TopAbs_FORWARD)));
}

}  // namespace remeshd::kernel
