#include "engine/kernel/brep.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepGProp_Domain.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepGProp_Sinert.hxx>
#include <BRepGProp_Vinert.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "engine/base/error.h"
#include "engine/kernel/brep_shapes.h"

namespace remeshd::kernel {

/// Element i is at index i + 1: OCCT counts from one.
struct BrepShapes {
  TopTools_IndexedMapOfShape cells, faces, edges, vertices;

  [[nodiscard]] const TopTools_IndexedMapOfShape& of(Element kind) const {
    switch (kind) {
      case Element::Cell:
        return cells;
      case Element::Face:
        return faces;
      case Element::Edge:
        return edges;
      case Element::Vertex:
        break;
    }
    return vertices;
  }
};

namespace {

// Kernel units: a model's diagonal is 128 to 256 of them.
constexpr double kMeshAngle = 0.12;      // rad between neighbouring facets of a curved face
constexpr double kMeshDeflection = 0.5;  // far above what the angle asks for
constexpr double kMeshMinimum = 1e-3;    // else small holes are meshed as triangles
constexpr double kTurning = 0.1;         // rad between points of an edge; 6 degrees are promised
constexpr double kOrderQuantum = 1e-5;   // a hundred times OCCT's own tolerance

Vec3 vec(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }
Vec3 vec(const gp_Pnt& p) { return vec(p.XYZ()); }

/// Rounds so that values that differ by noise compare equal; the offset keeps round values, which
/// models are full of, away from the borders.
std::int64_t quantum(double value) {
  return static_cast<std::int64_t>(std::floor(value / kOrderQuantum + 0.37));
}

using Key = std::vector<std::int64_t>;

void append(Key& key, const Vec3& p) {
  for (const double c : {p.x, p.y, p.z}) key.push_back(quantum(c));
}

/// The shapes of a map ordered by their keys.
template <typename KeyOf>
void sort_shapes(TopTools_IndexedMapOfShape& map, KeyOf key_of) {
  std::vector<std::pair<Key, int>> order;
  for (int i = 1; i <= map.Extent(); ++i) order.emplace_back(key_of(map(i)), i);
  std::sort(order.begin(), order.end());
  TopTools_IndexedMapOfShape sorted;
  for (const auto& [key, i] : order) sorted.Add(map(i));
  map.Exchange(sorted);
}

struct Moments {
  double area = 0;
  Vec3 centroid;
  double swept_volume = 0;  ///< of the pyramid to the reference point
};

/// Integrals over a face. BRepGProp's own entry takes another reference point for each face.
Moments moments_of(const TopoDS_Face& face, const gp_Pnt& reference) {
  BRepGProp_Face integrand(face);
  BRepGProp_Domain domain(face);
  BRepGProp_Sinert surface(integrand, domain, reference);
  domain.Init(face);
  BRepGProp_Vinert volume(integrand, domain, reference);
  return {surface.Mass(), vec(surface.CentreOfMass()), volume.Mass()};
}

BrepEdge describe_edge(const TopoDS_Edge& edge) {
  BrepEdge out;
  const BRepAdaptor_Curve curve(edge);
  const double first = curve.FirstParameter();
  const double last = curve.LastParameter();
  for (const int end : {0, 1}) {
    gp_Pnt p;
    gp_Vec d;
    curve.D1(end == 0 ? first : last, p, d);
    if (d.Magnitude() > gp::Resolution()) out.tangents[end] = vec(d.Normalized().XYZ());
  }
  switch (curve.GetType()) {
    case GeomAbs_Line:
      out.kind = BrepEdge::Kind::Line;
      out.length = last - first;
      out.points = {vec(curve.Value(first)), vec(curve.Value(last))};
      break;
    case GeomAbs_Circle: {
      const gp_Circ circle = curve.Circle();
      out.kind = BrepEdge::Kind::Circle;
      out.centre = vec(circle.Location());
      out.axis = vec(circle.Axis().Direction().XYZ());
      out.radius = circle.Radius();
      out.length = out.radius * (last - first);
      const int n = std::max(2, static_cast<int>(std::ceil((last - first) / kTurning)));
      for (int i = 0; i <= n; ++i)
        out.points.push_back(vec(curve.Value(first + (last - first) * i / n)));
      break;
    }
    default: {
      out.length = GCPnts_AbscissaPoint::Length(curve, 1e-9);
      const GCPnts_TangentialDeflection samples(curve, kTurning, kMeshDeflection, 3);
      for (int i = 1; i <= samples.NbPoints(); ++i) out.points.push_back(vec(samples.Value(i)));
      break;
    }
  }
  return out;
}

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
    brep_.points.push_back(vec(p));
    return static_cast<int>(brep_.points.size()) - 1;
  }

  Brep& brep_;
  std::vector<std::vector<int>> of_edge_;
};

/// From kernel units to the model's.
void unscale(Brep& brep, double scale) {
  const double l = 1 / scale;
  for (BrepCell& cell : brep.cells) cell.volume *= l * l * l;
  for (BrepFace& face : brep.faces) {
    face.area *= l * l;
    face.centroid = l * face.centroid;
  }
  for (BrepEdge& edge : brep.edges) {
    edge.length *= l;
    edge.centre = l * edge.centre;
    edge.radius *= l;
    for (Vec3& p : edge.points) p = l * p;
  }
  for (BrepVertex& vertex : brep.vertices) vertex.position = l * vertex.position;
  for (Vec3& p : brep.points) p = l * p;
  brep.scale = scale;
}

void describe_into(Brep& brep, const TopoDS_Shape& shape,
                   const std::vector<std::pair<TopoDS_Shape, std::string>>& labels) {
  auto shapes = std::make_shared<BrepShapes>();
  TopExp::MapShapes(shape, TopAbs_SOLID, shapes->cells);
  TopTools_IndexedMapOfShape all_edges;
  // Faces and edges of solids only: nothing dangling is asked for, and nothing may dangle.
  TopExp::MapShapes(shape, TopAbs_FACE, shapes->faces);
  TopExp::MapShapes(shape, TopAbs_EDGE, all_edges);
  TopExp::MapShapes(shape, TopAbs_VERTEX, shapes->vertices);
  for (int i = 1; i <= all_edges.Extent(); ++i)
    if (!BRep_Tool::Degenerated(TopoDS::Edge(all_edges(i)))) shapes->edges.Add(all_edges(i));
  if (shapes->cells.IsEmpty()) throw error::kernel_failure("the result holds no solid");

  sort_shapes(shapes->vertices, [](const TopoDS_Shape& v) {
    Key key;
    append(key, vec(BRep_Tool::Pnt(TopoDS::Vertex(v))));
    return key;
  });
  sort_shapes(shapes->edges, [](const TopoDS_Shape& e) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(e));
    Key key;
    append(key, vec(curve.Value(0.5 * (curve.FirstParameter() + curve.LastParameter()))));
    append(key, vec(curve.Value(curve.FirstParameter())));
    append(key, vec(curve.Value(curve.LastParameter())));
    return key;
  });
  // Measured once, before sorting: the map of faces is reordered by these numbers.
  TopTools_IndexedMapOfShape unsorted = shapes->faces;
  const gp_Pnt reference = BRep_Tool::Pnt(TopoDS::Vertex(shapes->vertices(1)));
  std::vector<Moments> measured;
  for (int i = 1; i <= unsorted.Extent(); ++i)
    measured.push_back(moments_of(TopoDS::Face(unsorted(i).Oriented(TopAbs_FORWARD)), reference));
  const auto moments = [&](const TopoDS_Shape& f) -> const Moments& {
    return measured[static_cast<std::size_t>(unsorted.FindIndex(f)) - 1];
  };
  sort_shapes(shapes->faces, [&](const TopoDS_Shape& f) {
    Key key;
    append(key, moments(f).centroid);
    key.push_back(quantum(moments(f).area));
    Key bounds;
    for (TopExp_Explorer it(f, TopAbs_EDGE); it.More(); it.Next())
      bounds.push_back(shapes->edges.FindIndex(it.Current()));
    std::sort(bounds.begin(), bounds.end());
    key.insert(key.end(), bounds.begin(), bounds.end());
    return key;
  });
  sort_shapes(shapes->cells, [&](const TopoDS_Shape& c) {
    Key key;
    for (TopExp_Explorer it(c, TopAbs_FACE); it.More(); it.Next())
      key.push_back(shapes->faces.FindIndex(it.Current()));
    std::sort(key.begin(), key.end());
    return key;
  });
  brep.shapes = shapes;

  for (int i = 1; i <= shapes->vertices.Extent(); ++i)
    brep.vertices.push_back({vec(BRep_Tool::Pnt(TopoDS::Vertex(shapes->vertices(i))))});
  for (int i = 1; i <= shapes->edges.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(shapes->edges(i).Oriented(TopAbs_FORWARD));
    BrepEdge out = describe_edge(edge);
    out.vertices = {index_of(brep, Element::Vertex, TopExp::FirstVertex(edge)),
                    index_of(brep, Element::Vertex, TopExp::LastVertex(edge))};
    if (out.vertices[0] < 0 || out.vertices[1] < 0)
      throw error::kernel_failure("an edge has no end");
    out.points.front() = brep.vertices[out.vertices[0]].position;
    out.points.back() = brep.vertices[out.vertices[1]].position;
    brep.edges.push_back(std::move(out));
  }
  for (int i = 1; i <= shapes->faces.Extent(); ++i) {
    BrepFace out;
    out.area = moments(shapes->faces(i)).area;
    out.centroid = moments(shapes->faces(i)).centroid;
    for (TopExp_Explorer it(shapes->faces(i), TopAbs_EDGE); it.More(); it.Next())
      if (const int e = index_of(brep, Element::Edge, it.Current()); e >= 0)
        out.edges.insert(out.edges.end(), it.Current().Orientation() == TopAbs_INTERNAL ? 2 : 1, e);
    std::sort(out.edges.begin(), out.edges.end());
    brep.faces.push_back(std::move(out));
  }
  for (int i = 1; i <= shapes->cells.Extent(); ++i) {
    BrepCell cell;
    for (TopExp_Explorer it(shapes->cells(i), TopAbs_FACE); it.More(); it.Next()) {
      const int f = index_of(brep, Element::Face, it.Current());
      const bool behind = it.Current().Orientation() == TopAbs_FORWARD;
      int& side = brep.faces[f].cells[behind ? 0 : 1];
      if (side >= 0) throw error::kernel_failure("two cells overlap");
      side = i - 1;
      cell.volume += (behind ? 1 : -1) * moments(it.Current()).swept_volume;
      cell.faces.push_back(f);
    }
    std::sort(cell.faces.begin(), cell.faces.end());
    brep.cells.push_back(std::move(cell));
  }
  for (const BrepFace& face : brep.faces)
    if (face.cells[0] < 0 && face.cells[1] < 0)
      throw error::kernel_failure("a face of the result bounds no cell");
  for (const auto& [face, label] : labels)
    if (const int f = index_of(brep, Element::Face, face); f >= 0) brep.faces[f].label = label;

  mesh(shape);
  NodeNumbers nodes(brep);
  for (int i = 1; i <= shapes->faces.Extent(); ++i)
    nodes.add_face(i - 1, TopoDS::Face(shapes->faces(i).Oriented(TopAbs_FORWARD)));
}

}  // namespace

double unit_scale(double diagonal) { return std::exp2(7 - std::floor(std::log2(diagonal))); }

Brep describe(const TopoDS_Shape& shape, double scale,
              const std::vector<std::pair<TopoDS_Shape, std::string>>& labels) {
  try {
    Brep brep;
    describe_into(brep, shape, labels);
    unscale(brep, scale);
    return brep;
  } catch (const Standard_Failure& failure) {
    throw error::kernel_failure(failure.GetMessageString());
  }
}

const TopoDS_Shape& shape_of(const Brep& brep, Element kind, int index) {
  return brep.shapes->of(kind)(index + 1);
}

int index_of(const Brep& brep, Element kind, const TopoDS_Shape& shape) {
  return brep.shapes->of(kind).FindIndex(shape) - 1;
}

}  // namespace remeshd::kernel
