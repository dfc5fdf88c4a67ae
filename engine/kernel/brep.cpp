#include "engine/kernel/brep.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <cstdint>

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
constexpr double kOrderQuantum = 1e-5;  // a hundred times OCCT's own tolerance

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

/// From kernel units to the model's.
void unscale(Brep& brep, double scale) {
  const double l = 1 / scale;
  for (BrepCell& cell : brep.cells) cell.volume *= l * l * l;
  for (BrepFace& face : brep.faces) {
    face.area *= l * l;
    face.swept_volume *= l * l * l;
    face.centroid = l * face.centroid;
  }
  for (BrepEdge& edge : brep.edges) {
    edge.length *= l;
    edge.centre = l * edge.centre;
    edge.radius *= l;
    for (Vec3& p : edge.points) p = l * p;
    for (auto& sample : edge.samples)
      for (Vec3& v : sample) v = l * v;
  }
  for (BrepVertex& vertex : brep.vertices) vertex.position = l * vertex.position;
  for (Vec3& p : brep.points) p = l * p;
  brep.reference = l * brep.reference;
  brep.scale = scale;
}

/// The elements of a shape, in the CAD kernel's order. Degenerate edges (poles, apexes) are left
/// out.
std::shared_ptr<BrepShapes> collect(const TopoDS_Shape& shape) {
  auto shapes = std::make_shared<BrepShapes>();
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_SOLID, shapes->cells);
  TopExp::MapShapes(shape, TopAbs_FACE, shapes->faces);
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  TopExp::MapShapes(shape, TopAbs_VERTEX, shapes->vertices);
  for (int i = 1; i <= edges.Extent(); ++i)
    if (!BRep_Tool::Degenerated(TopoDS::Edge(edges(i)))) shapes->edges.Add(edges(i));
  if (shapes->cells.IsEmpty()) throw error::kernel_failure("the result holds no solid");
  return shapes;
}

Vec3 position(const TopoDS_Shape& vertex) { return vec(BRep_Tool::Pnt(TopoDS::Vertex(vertex))); }

TopoDS_Face forward_face(const TopoDS_Shape& face) {
  return TopoDS::Face(face.Oriented(TopAbs_FORWARD));
}

void sort_vertices(BrepShapes& shapes) {
  sort_shapes(shapes.vertices, [](const TopoDS_Shape& v) {
    Key key;
    append(key, position(v));
    return key;
  });
}

/// Sorts edges, faces and cells by their geometry; returns the moments of the faces in their new
/// order.
std::vector<FaceMoments> sort_by_geometry(BrepShapes& shapes, const Vec3& reference,
                                          const Run& run) {
  sort_shapes(shapes.edges, [](const TopoDS_Shape& e) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(e));
    const double first = curve.FirstParameter(), last = curve.LastParameter();
    Key key;
    for (const double t : {0.5 * (first + last), first, last}) append(key, vec(curve.Value(t)));
    return key;
  });
  TopTools_DataMapOfShapeInteger at;
  std::vector<FaceMoments> measured;
  for (int i = 1; i <= shapes.faces.Extent(); ++i) {
    run.poll();
    at.Bind(shapes.faces(i), i - 1);
    measured.push_back(moments_of(forward_face(shapes.faces(i)), reference));
  }
  sort_shapes(shapes.faces, [&](const TopoDS_Shape& f) {
    const FaceMoments& moments = measured[at(f)];
    Key key, bounds;
    append(key, moments.centroid);
    key.push_back(quantum(moments.area));
    for (TopExp_Explorer it(f, TopAbs_EDGE); it.More(); it.Next())
      bounds.push_back(shapes.edges.FindIndex(it.Current()));
    std::sort(bounds.begin(), bounds.end());
    key.insert(key.end(), bounds.begin(), bounds.end());
    return key;
  });
  sort_shapes(shapes.cells, [&](const TopoDS_Shape& c) {
    Key key;
    for (TopExp_Explorer it(c, TopAbs_FACE); it.More(); it.Next())
      key.push_back(shapes.faces.FindIndex(it.Current()));
    std::sort(key.begin(), key.end());
    return key;
  });
  std::vector<FaceMoments> sorted;
  for (int i = 1; i <= shapes.faces.Extent(); ++i) sorted.push_back(measured[at(shapes.faces(i))]);
  return sorted;
}

/// Fills in vertices and the incidences of all elements. Throws Error(KERNEL_FAILURE).
void connect(Brep& brep, double scale) {
  const auto failure_at = [&](const char* what, const TopoDS_Shape& shape) {
    return error::kernel_failure(what, in_model_units(point_on(shape), scale));
  };
  const BrepShapes& shapes = *brep.shapes;
  brep.vertices.resize(shapes.vertices.Extent());
  brep.edges.resize(shapes.edges.Extent());
  brep.faces.resize(shapes.faces.Extent());
  brep.cells.resize(shapes.cells.Extent());
  for (std::size_t v = 0; v < brep.vertices.size(); ++v)
    brep.vertices[v].position = position(shapes.vertices(static_cast<int>(v) + 1));
  for (std::size_t e = 0; e < brep.edges.size(); ++e) {
    const TopoDS_Edge edge =
        TopoDS::Edge(shapes.edges(static_cast<int>(e) + 1).Oriented(TopAbs_FORWARD));
    brep.edges[e].vertices = {index_of(brep, Element::Vertex, TopExp::FirstVertex(edge)),
                              index_of(brep, Element::Vertex, TopExp::LastVertex(edge))};
    if (std::ranges::min(brep.edges[e].vertices) < 0) throw failure_at("an edge has no end", edge);
  }
  for (std::size_t f = 0; f < brep.faces.size(); ++f) {
    auto& edges = brep.faces[f].edges;
    for (TopExp_Explorer it(shapes.faces(static_cast<int>(f) + 1), TopAbs_EDGE); it.More();
         it.Next())
      if (const int e = index_of(brep, Element::Edge, it.Current()); e >= 0)
        edges.insert(edges.end(), it.Current().Orientation() == TopAbs_INTERNAL ? 2 : 1, e);
    std::sort(edges.begin(), edges.end());
  }
  for (std::size_t c = 0; c < brep.cells.size(); ++c) {
    auto& faces = brep.cells[c].faces;
    for (TopExp_Explorer it(shapes.cells(static_cast<int>(c) + 1), TopAbs_FACE); it.More();
         it.Next()) {
      const int f = index_of(brep, Element::Face, it.Current());
      int& side = brep.faces[f].cells[it.Current().Orientation() == TopAbs_FORWARD ? 0 : 1];
      if (side >= 0) throw failure_at("two cells overlap", it.Current());
      side = static_cast<int>(c);
      faces.push_back(f);
    }
    std::sort(faces.begin(), faces.end());
  }
  for (std::size_t f = 0; f < brep.faces.size(); ++f)
    if (std::ranges::max(brep.faces[f].cells) < 0)
      throw failure_at("a face of the result bounds no cell",
                       shapes.faces(static_cast<int>(f) + 1));
}

void fill_measures(Brep& brep, const std::vector<FaceMoments>& moments) {
  for (std::size_t e = 0; e < brep.edges.size(); ++e) {
    BrepEdge& edge = brep.edges[e];
    measure_edge(TopoDS::Edge(brep.shapes->edges(static_cast<int>(e) + 1).Oriented(TopAbs_FORWARD)),
                 edge);
    edge.points.front() = brep.vertices[edge.vertices[0]].position;
    edge.points.back() = brep.vertices[edge.vertices[1]].position;
  }
  for (std::size_t f = 0; f < brep.faces.size(); ++f) {
    BrepFace& face = brep.faces[f];
    face.area = moments[f].area;
    face.centroid = moments[f].centroid;
    face.swept_volume = moments[f].swept_volume;
    if (face.cells[0] >= 0) brep.cells[face.cells[0]].volume += moments[f].swept_volume;
    if (face.cells[1] >= 0) brep.cells[face.cells[1]].volume -= moments[f].swept_volume;
  }
}

}  // namespace

BrepEdge straight_edge(int a, int b, const Vec3& p, const Vec3& q) {
  BrepEdge edge;
  edge.kind = BrepEdge::Kind::Line;
  edge.vertices = {a, b};
  edge.length = distance(p, q);
  edge.tangents[0] = edge.tangents[1] = normalised(q - p);
  edge.points = {p, q};
  edge.chain = {a, b};
  return edge;
}

double unit_scale(double diagonal) { return std::exp2(7 - std::floor(std::log2(diagonal))); }

Brep describe(const TopoDS_Shape& shape, double scale, const Run& run,
              const std::optional<Vec3>& reference) {
  try {
    Brep brep;
    const auto shapes = collect(shape);
    sort_vertices(*shapes);
    // Swept volumes add up to volumes only with the same reference for all faces.
    brep.reference = reference ? scale * *reference : position(shapes->vertices(1));
    const std::vector<FaceMoments> moments = sort_by_geometry(*shapes, brep.reference, run);
    brep.shapes = shapes;
    connect(brep, scale);
    fill_measures(brep, moments);
    triangulate(brep, shape, scale, run);
    unscale(brep, scale);
    return brep;
  } catch (const Standard_Failure& failure) {
    throw error::kernel_failure(failure.GetMessageString());
  }
}

Brep describe_primitive(const TopoDS_Shape& solid, double scale,
                        const std::vector<std::pair<TopoDS_Shape, std::string>>& labels) {
  Brep brep;
  brep.shapes = collect(solid);
  connect(brep, scale);
  for (const auto& [face, label] : labels)
    if (const int f = index_of(brep, Element::Face, face); f >= 0) brep.faces[f].label = label;
  unscale(brep, scale);
  return brep;
}

std::optional<Vec3> point_on(const TopoDS_Shape& shape) {
  for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    double first = 0, last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    if (!curve.IsNull()) return vec(curve->Value(0.5 * (first + last)));
  }
  TopExp_Explorer vertex(shape, TopAbs_VERTEX);
  if (!vertex.More()) return std::nullopt;
  return position(vertex.Current());
}

Vec3 vec(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }
Vec3 vec(const gp_Pnt& p) { return vec(p.XYZ()); }

int add_point(Brep& brep, const gp_Pnt& p) {
  brep.points.push_back(vec(p));
  return static_cast<int>(brep.points.size()) - 1;
}

std::optional<Vec3> in_model_units(const std::optional<Vec3>& p, double scale) {
  return p ? std::optional(*p / scale) : std::nullopt;
}

const TopoDS_Shape& shape_of(const Brep& brep, Element kind, int index) {
  return brep.shapes->of(kind)(index + 1);
}

TopoDS_Face face_shape(const Brep& brep, int face) {
  return TopoDS::Face(shape_of(brep, Element::Face, face).Oriented(TopAbs_FORWARD));
}

int index_of(const Brep& brep, Element kind, const TopoDS_Shape& shape) {
  return brep.shapes->of(kind).FindIndex(shape) - 1;
}

}  // namespace remeshd::kernel
