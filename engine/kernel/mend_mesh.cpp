#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "engine/kernel/brep_shapes.h"

namespace remeshd::kernel {
namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point2 = K::Point_2;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    K, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<int, K>,
                                            CGAL::Constrained_triangulation_face_base_2<K>>>;

constexpr double kStep = 0.24;        // rad between nodes on round faces
constexpr double kSameCorner = 1e-3;  // kernel units: images of one node this near are one corner
constexpr double kShortest = 1e-6;    // kernel units: segments are not split below
constexpr int kRounds = 40;
constexpr std::size_t kMaxInterior = 20'000;
constexpr double kAreaError = 0.05;  // of the face; more means that it was not covered

/// A face's border in its parameters, stretched so that lengths are about those in space.
struct Border {
  struct Corner {
    Point2 p;
    int node;
  };
  struct Segment {
    int a, b;         ///< corners
    int edge, index;  ///< of the edge's polyline; -1: at a pole
    int uses;         ///< 2: the face on both sides
  };
  std::vector<Corner> corners;
  std::vector<Segment> segments;
};

/// A segment of an edge's polyline.
struct Cut {
  int edge, index;
  friend auto operator<=>(const Cut&, const Cut&) = default;
};

class Mender {
 public:
  Mender(Brep& brep, EdgeChains& chains) : brep_(brep), chains_(chains), faces_at_(chains.size()) {
    for (std::size_t f = 0; f < brep.faces.size(); ++f)
      for (const int e : brep.faces[f].edges) faces_at_[e].push_back(static_cast<int>(f));
  }

  bool mend(const std::vector<int>& bad) {
    std::set<int> faces(bad.begin(), bad.end());
    for (int round = 0;; ++round) {
      std::set<Cut> cuts;
      for (const int f : faces)
        if (!find_cuts(border_of(f), cuts)) return false;
      if (cuts.empty()) break;
      if (round == kRounds) return false;
      for (auto it = cuts.rbegin(); it != cuts.rend(); ++it) {  // the highest index first
        split(*it);
        faces.insert(faces_at_[it->edge].begin(), faces_at_[it->edge].end());
      }
    }
    return std::ranges::all_of(faces, [&](int f) { return triangulate(f); });
  }

 private:
  [[nodiscard]] TopoDS_Face face_shape(int f) const {
    return TopoDS::Face(shape_of(brep_, Element::Face, f).Oriented(TopAbs_FORWARD));
  }

  int add_point(const gp_Pnt& p) {
    brep_.points.push_back(Vec3{p.X(), p.Y(), p.Z()});
    return static_cast<int>(brep_.points.size()) - 1;
  }

  /// The polyline of an edge that the CAD kernel gave none.
  void require_chain(int e) {
    std::vector<EdgeNode>& chain = chains_[e];
    if (!chain.empty()) return;
    const BRepAdaptor_Curve curve(TopoDS::Edge(shape_of(brep_, Element::Edge, e)));
    const double first = curve.FirstParameter(), last = curve.LastParameter();
    const int n = brep_.edges[e].kind == BrepEdge::Kind::Line
                      ? 1
                      : std::max(2, static_cast<int>(brep_.edges[e].points.size() + 1) / 2);
    chain.push_back({brep_.edges[e].vertices[0], first});
    for (int i = 1; i < n; ++i) {
      const double t = first + (last - first) * i / n;
      chain.push_back({add_point(curve.Value(t)), t});
    }
    chain.push_back({brep_.edges[e].vertices[1], last});
  }

  void split(const Cut& cut) {
    std::vector<EdgeNode>& chain = chains_[cut.edge];
    const BRepAdaptor_Curve curve(TopoDS::Edge(shape_of(brep_, Element::Edge, cut.edge)));
    const double t = 0.5 * (chain[cut.index].parameter + chain[cut.index + 1].parameter);
    chain.insert(chain.begin() + cut.index + 1, {add_point(curve.Value(t)), t});
  }

  Border border_of(int f) {
    const TopoDS_Face face = face_shape(f);
    const BRepAdaptor_Surface surface(face);
    gp_Pnt at;
    gp_Vec along_u, along_v;
    surface.D1(0.5 * (surface.FirstUParameter() + surface.LastUParameter()),
               0.5 * (surface.FirstVParameter() + surface.LastVParameter()), at, along_u, along_v);
    stretch_ = {along_u.Magnitude(), along_v.Magnitude()};

    Border border;
    std::multimap<int, int> of_node;
    const auto corner = [&](int node, const gp_Pnt2d& uv) {
      const Point2 p(uv.X() * stretch_[0], uv.Y() * stretch_[1]);
      const auto [begin, end] = of_node.equal_range(node);
      for (auto it = begin; it != end; ++it)
        if (CGAL::squared_distance(border.corners[it->second].p, p) < kSameCorner * kSameCorner)
          return it->second;
      border.corners.push_back({p, node});
      of_node.emplace(node, static_cast<int>(border.corners.size()) - 1);
      return static_cast<int>(border.corners.size()) - 1;
    };
    std::map<std::array<int, 4>, int> known;  // of segments
    const auto add = [&](int a, int b, int edge, int index, int uses) {
      if (a == b) return;
      const auto [it, fresh] = known.try_emplace({std::min(a, b), std::max(a, b), edge, index},
                                                 static_cast<int>(border.segments.size()));
      if (fresh)
        border.segments.push_back({a, b, edge, index, uses});
      else
        border.segments[it->second].uses += uses;
    };
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      double first = 0, last = 0;
      const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
      const int e = index_of(brep_, Element::Edge, edge);
      const int uses = edge.Orientation() == TopAbs_INTERNAL ? 2 : 1;
      if (e < 0) {
        const int v = index_of(brep_, Element::Vertex, TopExp::FirstVertex(edge));
        const gp_Pnt2d begin = curve->Value(first), end = curve->Value(last);
        const int n = std::max(1, static_cast<int>(std::ceil(begin.Distance(end) / kStep)));
        for (int i = 0; i < n; ++i)
          add(corner(v, curve->Value(first + (last - first) * i / n)),
              corner(v, curve->Value(first + (last - first) * (i + 1) / n)), -1,
              static_cast<int>(border.segments.size()), uses);
        continue;
      }
      require_chain(e);
      const std::vector<EdgeNode>& chain = chains_[e];
      int before = corner(chain[0].node, curve->Value(chain[0].parameter));
      for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
        const int next = corner(chain[i + 1].node, curve->Value(chain[i + 1].parameter));
        add(before, next, e, static_cast<int>(i), uses);
        before = next;
      }
    }
    return border;
  }

  [[nodiscard]] double length(const Border::Segment& s) const {
    if (s.edge < 0) return 0;
    return distance(brep_.points[chains_[s.edge][s.index].node],
                    brep_.points[chains_[s.edge][s.index + 1].node]);
  }
  [[nodiscard]] bool can_split(const Border::Segment& s) const {
    return s.edge >= 0 && brep_.edges[s.edge].kind != BrepEdge::Kind::Line && length(s) > kShortest;
  }

  static bool clash(const Border& border, const Border::Segment& s, const Border::Segment& t) {
    const auto at = [&](int corner) -> const Point2& { return border.corners[corner].p; };
    for (const auto& [a, b] : {std::pair(s.a, s.b), std::pair(s.b, s.a)})
      for (const auto& [c, d] : {std::pair(t.a, t.b), std::pair(t.b, t.a)})
        if (a == c)
          return b == d || (CGAL::collinear(at(a), at(b), at(d)) &&
                            CGAL::angle(at(b), at(a), at(d)) == CGAL::ACUTE);
    return CGAL::do_intersect(K::Segment_2(at(s.a), at(s.b)), K::Segment_2(at(t.a), at(t.b)));
  }

  /// Adds what must be split so that the border does not cross itself: of two segments the longer,
  /// because the chords of two touching circles part only where the wider circle's are no longer
  /// than the other's. False where splitting does not help.
  bool find_cuts(const Border& border, std::set<Cut>& cuts) const {
    const auto& segments = border.segments;
    std::vector<CGAL::Bbox_2> boxes;
    for (const Border::Segment& s : segments)
      boxes.push_back(border.corners[s.a].p.bbox() + border.corners[s.b].p.bbox());
    for (std::size_t i = 0; i < segments.size(); ++i)
      for (std::size_t j = i + 1; j < segments.size(); ++j) {
        if (!CGAL::do_overlap(boxes[i], boxes[j])) continue;
        const Border::Segment &s = segments[i], &t = segments[j];
        if (!clash(border, s, t)) continue;
        const bool first = can_split(s) && (!can_split(t) || length(s) >= length(t));
        const Border::Segment& longer = first ? s : t;
        if (!can_split(longer)) return false;
        cuts.insert({longer.edge, longer.index});
      }
    return true;
  }

  bool triangulate(int f) {
    const Border border = border_of(f);
    Triangulation mesh;
    std::vector<Triangulation::Vertex_handle> handles;
    for (const Border::Corner& corner : border.corners) {
      handles.push_back(mesh.insert(corner.p));
      handles.back()->info() = corner.node;
    }
    if (mesh.number_of_vertices() != border.corners.size()) return false;
    std::map<std::pair<int, int>, int> uses;
    for (const Border::Segment& s : border.segments) {
      mesh.insert_constraint(handles[s.a], handles[s.b]);
      uses[std::minmax(s.a, s.b)] += s.uses;
    }
    if (mesh.number_of_vertices() != border.corners.size()) return false;
    std::map<Triangulation::Vertex_handle, int> corner_of;
    for (std::size_t i = 0; i < handles.size(); ++i) corner_of[handles[i]] = static_cast<int>(i);
    const auto border_uses = [&](Triangulation::Face_handle t, int i) {
      if (!t->is_constrained(i)) return 0;
      const int a = corner_of.at(t->vertex(Triangulation::cw(i)));
      const int b = corner_of.at(t->vertex(Triangulation::ccw(i)));
      return uses.at(std::minmax(a, b));
    };
    insert_interior(f, border, mesh);

    // Inside is what an odd number of border segments parts from the outside.
    std::map<Triangulation::Face_handle, bool> inside{{mesh.infinite_face(), false}};
    std::vector<Triangulation::Face_handle> todo{mesh.infinite_face()};
    while (!todo.empty()) {
      const Triangulation::Face_handle t = todo.back();
      todo.pop_back();
      for (int i = 0; i < 3; ++i) {
        const bool beyond = inside.at(t) != (border_uses(t, i) % 2 == 1);
        if (inside.try_emplace(t->neighbor(i), beyond).second) todo.push_back(t->neighbor(i));
      }
    }
    BrepFace& out = brep_.faces[f];
    out.triangles.clear();
    double area = 0;
    const BRepAdaptor_Surface surface(face_shape(f));
    for (auto t = mesh.finite_faces_begin(); t != mesh.finite_faces_end(); ++t) {
      if (!inside.at(t)) continue;
      for (int i = 0; i < 3; ++i)
        if (int& node = t->vertex(i)->info(); node < 0) {
          const Point2& p = t->vertex(i)->point();
          node = add_point(surface.Value(p.x() / stretch_[0], p.y() / stretch_[1]));
        }
      const int a = t->vertex(0)->info(), b = t->vertex(1)->info(), c = t->vertex(2)->info();
      if (a == b || b == c || c == a) continue;  // at a pole
      out.triangles.push_back({a, b, c});
      area +=
          0.5 * norm(cross(brep_.points[b] - brep_.points[a], brep_.points[c] - brep_.points[a]));
    }
    // Nothing is said of slivers: chords may be as far off as these are wide.
    return std::fabs(area - out.area) <= kAreaError * out.area || out.area < 1e-2;
  }

  /// Puts nodes on a round face, about as far from its border as from each other; their numbers
  /// are -1 until a triangle needs them.
  void insert_interior(int f, const Border& border, Triangulation& mesh) {
    const BRepAdaptor_Surface surface(face_shape(f));
    if (surface.GetType() == GeomAbs_Plane) return;
    CGAL::Bbox_2 box = border.corners.front().p.bbox();
    for (const Border::Corner& corner : border.corners) box += corner.p.bbox();
    const bool straight =
        surface.GetType() == GeomAbs_Cylinder || surface.GetType() == GeomAbs_Cone;
    const double step_u = kStep * stretch_[0];
    double step_v = kStep * stretch_[1];
    if (straight) step_v = std::max(step_u, (box.ymax() - box.ymin()) / 12);
    const double nu = (box.xmax() - box.xmin()) / step_u, nv = (box.ymax() - box.ymin()) / step_v;
    if (!(nu * nv < kMaxInterior)) return;
    std::vector<Point2> points;
    for (int i = 0; i < nu; ++i)
      for (int j = 0; j < nv; ++j) {
        // Rows shifted by half a step make better triangles.
        const Point2 p(box.xmin() + step_u * (i + (j % 2 == 0 ? 0.3 : 0.8)),
                       box.ymin() + step_v * (j + 0.45));
        const bool far = std::ranges::all_of(border.segments, [&](const Border::Segment& s) {
          const double reach = 0.4 * std::min(step_u, step_v);
          return CGAL::squared_distance(K::Segment_2(border.corners[s.a].p, border.corners[s.b].p),
                                        p) > reach * reach;
        });
        if (far && p.x() < box.xmax() && p.y() < box.ymax()) points.push_back(p);
      }
    for (const Point2& p : points) mesh.insert(p)->info() = -1;
  }

  Brep& brep_;
  EdgeChains& chains_;
  std::vector<std::vector<int>> faces_at_;
  std::array<double, 2> stretch_{};
};

}  // namespace

bool mend_faces(Brep& brep, EdgeChains& chains, const std::vector<int>& bad) {
  return Mender(brep, chains).mend(bad);
}

}  // namespace remeshd::kernel
