#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <ElSLib.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <Geom_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "engine/kernel/border_mesh.h"
#include "engine/kernel/brep_shapes.h"
#include "engine/kernel/curve_points.h"

namespace remeshd::kernel {
namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point2 = K::Point_2;

struct FaceMeshLimits {
  double same_corner = 1e-3;  ///< kernel units: images of one node this near are one corner
  double shortest = 1e-6;     ///< kernel units: segments are not split below
  int rounds = 40;            ///< of splitting segments that cross
  std::size_t most_interior = 20'000;  ///< nodes in a doubly curved face; for more, none
};
constexpr FaceMeshLimits kFaceMeshLimits;

Point2 point2(const std::array<double, 2>& p) { return {p[0], p[1]}; }

/// A segment of an edge's polyline and where it is split.
struct Cut {
  int edge, index;
  double parameter;  ///< of the edge's curve
  friend bool operator<(const Cut& a, const Cut& b) {
    return std::tie(a.edge, a.index, a.parameter) < std::tie(b.edge, b.index, b.parameter);
  }
};

class FaceMesher {
 public:
  FaceMesher(Brep& brep, EdgeChains& chains)
      : brep_(brep), chains_(chains), faces_at_(chains.size()) {
    for (std::size_t f = 0; f < brep.faces.size(); ++f)
      for (const int e : brep.faces[f].edges) faces_at_[e].push_back(static_cast<int>(f));
  }

  /// Returns the faces that could not be triangulated.
  std::vector<int> mesh_all(const Run& run) {
    std::vector<int> bad;
    for (int e = 0; e < static_cast<int>(chains_.size()); ++e) require_chain(e);
    for (int f = 0; f < static_cast<int>(brep_.faces.size()); ++f) {
      run.poll();
      if (!triangulate(f)) bad.push_back(f);
    }
    return bad;
  }

  bool mend(const std::vector<int>& bad) {
    std::set<int> faces(bad.begin(), bad.end());
    for (const int f : faces)
      for (const int e : brep_.faces[f].edges) put_on_curve(e);
    for (int round = 0;; ++round) {
      std::set<Cut> cuts;
      for (const int f : faces)
        if (!find_cuts(border_of(f), cuts)) return false;
      if (cuts.empty()) break;
      if (round == kFaceMeshLimits.rounds) return false;
      for (auto it = cuts.rbegin(); it != cuts.rend(); ++it) {  // the highest index first
        split(*it);
        faces.insert(faces_at_[it->edge].begin(), faces_at_[it->edge].end());
      }
    }
    return std::ranges::all_of(faces, [&](int f) { return triangulate(f); });
  }

 private:
  /// Makes the polyline of an edge, unless it has one.
  void require_chain(int e) {
    std::vector<EdgeNode>& chain = chains_[e];
    if (!chain.empty()) return;
    const BRepAdaptor_Curve curve(TopoDS::Edge(shape_of(brep_, Element::Edge, e)));
    const double first = curve.FirstParameter(), last = curve.LastParameter();
    const int n = parts_of(brep_.edges[e]);
    chain.push_back({brep_.edges[e].vertices[0], first});
    for (int i = 1; i < n; ++i) {
      const double t = first + (last - first) * i / n;
      chain.push_back({add_point(brep_, curve.Value(t)), t});
    }
    chain.push_back({brep_.edges[e].vertices[1], last});
  }

  /// The number of segments, equal in parameter, of the polyline of an edge.
  static int parts_of(const BrepEdge& edge) {
    switch (edge.kind) {
      case BrepEdge::Kind::Line:
        return 1;
      case BrepEdge::Kind::Circle:
        return steps_of(edge.length / edge.radius, kChordTurning);
      case BrepEdge::Kind::Other:
        break;
    }
    return std::max(2, static_cast<int>(edge.points.size()) - 1);
  }

  /// Moves the inner nodes of an edge's polyline onto its curve: where edges are too near for the
  /// CAD kernel to tell them apart, its triangulation has nodes of one on the other.
  void put_on_curve(int e) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(shape_of(brep_, Element::Edge, e)));
    for (std::size_t i = 1; i + 1 < chains_[e].size(); ++i)
      brep_.points[chains_[e][i].node] = vec(curve.Value(chains_[e][i].parameter));
  }

  void split(const Cut& cut) {
    std::vector<EdgeNode>& chain = chains_[cut.edge];
    const BRepAdaptor_Curve curve(TopoDS::Edge(shape_of(brep_, Element::Edge, cut.edge)));
    const gp_Pnt place = curve.Value(cut.parameter);
    const int next = chain[cut.index + 1].node;  // perhaps of another cut of this segment
    if (distance(vec(place), brep_.points[next]) < 0.5 * kFaceMeshLimits.shortest) return;
    chain.insert(chain.begin() + cut.index + 1, {add_point(brep_, place), cut.parameter});
  }

  /// Finds the factors that make lengths in a face's parameters about those in space.
  void find_stretch(const TopoDS_Face& face) {
    const BRepAdaptor_Surface whole(face, /*Restriction=*/false);
    if (whole.GetType() == GeomAbs_Cylinder) {
      stretch_ = {whole.Cylinder().Radius(), 1};
      return;
    }
    const BRepAdaptor_Surface surface(face);  // computing its bounds takes time
    gp_Pnt at;
    gp_Vec along_u, along_v;
    surface.D1(0.5 * (surface.FirstUParameter() + surface.LastUParameter()),
               0.5 * (surface.FirstVParameter() + surface.LastVParameter()), at, along_u, along_v);
    stretch_ = {along_u.Magnitude(), along_v.Magnitude()};
  }

  /// Shrinks the border of a cylinder or cone along its straight lines, so that triangles follow
  /// these and none cuts off a piece across them.
  void flatten(Border& border) const {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Border::Corner& corner : border.corners) {
      low = std::min(low, corner.p[1]);
      high = std::max(high, corner.p[1]);
    }
    const double factor =
        std::min(1.0, kFaceTurning * stretch_[0] / std::max(high - low, kFaceMeshLimits.shortest));
    for (Border::Corner& corner : border.corners) corner.p[1] *= factor;
  }

  static bool is_ruled(const BRepAdaptor_Surface& surface) {
    return surface.GetType() == GeomAbs_Cylinder || surface.GetType() == GeomAbs_Cone;
  }

  /// The border of a plane face: its nodes lie in it, so that no curves in parameters are needed.
  Border plane_border(int f, const gp_Pln& plane) {
    Border border;
    std::map<int, int> of_node;
    const auto corner = [&](int node) {
      const auto [it, fresh] = of_node.try_emplace(node, static_cast<int>(border.corners.size()));
      if (fresh) {
        const Vec3& p = brep_.points[node];
        double u = 0, v = 0;
        ElSLib::Parameters(plane, {p.x, p.y, p.z}, u, v);
        border.corners.push_back({{u, v}, node});
      }
      return it->second;
    };
    const std::vector<int>& edges = brep_.faces[f].edges;
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const bool twice = k + 1 < edges.size() && edges[k + 1] == edges[k];
      const std::vector<EdgeNode>& chain = chains_[edges[k]];
      for (int i = 0; i + 1 < static_cast<int>(chain.size()); ++i)
        border.segments.push_back(
            {corner(chain[i].node), corner(chain[i + 1].node), edges[k], i, twice ? 2 : 1});
      k += twice ? 1 : 0;
    }
    return border;
  }

  Border border_of(int f) {
    const TopoDS_Face face = face_shape(brep_, f);
    const BRepAdaptor_Surface surface(face, /*Restriction=*/false);
    if (surface.GetType() == GeomAbs_Plane) {
      stretch_ = {1, 1};
      return plane_border(f, surface.Plane());
    }
    find_stretch(face);

    Border border;
    std::multimap<int, int> of_node;
    const auto corner = [&](int node, const gp_Pnt2d& uv) {
      const std::array<double, 2> p{uv.X() * stretch_[0], uv.Y() * stretch_[1]};
      const auto [begin, end] = of_node.equal_range(node);
      for (auto it = begin; it != end; ++it)
        if (std::hypot(border.corners[it->second].p[0] - p[0],
                       border.corners[it->second].p[1] - p[1]) < kFaceMeshLimits.same_corner)
          return it->second;
      border.corners.push_back({p, node});
      of_node.emplace(node, static_cast<int>(border.corners.size()) - 1);
      return static_cast<int>(border.corners.size()) - 1;
    };
    std::map<std::array<int, 4>, int> known;  // number of a segment
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
        const int n = std::max(1, static_cast<int>(std::ceil(begin.Distance(end) / kFaceTurning)));
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
    if (is_ruled(surface)) flatten(border);
    return border;
  }

  [[nodiscard]] double length(const Border::Segment& s) const {
    if (s.edge < 0) return 0;
    return distance(brep_.points[chains_[s.edge][s.index].node],
                    brep_.points[chains_[s.edge][s.index + 1].node]);
  }
  [[nodiscard]] bool can_split(const Border::Segment& s) const {
    return s.edge >= 0 && brep_.edges[s.edge].kind != BrepEdge::Kind::Line &&
           length(s) > kFaceMeshLimits.shortest;
  }

  /// Adds cuts where the curve of segment `s` comes nearest to the ends of another one, away from
  /// its own ends. Returns whether there is any.
  bool find_opposite(const Border::Segment& s, const Border::Segment& other,
                     std::set<Cut>& cuts) const {
    if (!can_split(s) || other.edge < 0) return false;
    const EdgeNode &from = chains_[s.edge][s.index], &to = chains_[s.edge][s.index + 1];
    double first = 0, last = 0;
    const Handle(Geom_Curve) curve =
        BRep_Tool::Curve(TopoDS::Edge(shape_of(brep_, Element::Edge, s.edge)), first, last);
    bool any = false;
    for (const int k : {0, 1}) {
      const Vec3& p = brep_.points[chains_[other.edge][other.index + k].node];
      const GeomAPI_ProjectPointOnCurve nearest({p.x, p.y, p.z}, curve,
                                                std::min(from.parameter, to.parameter),
                                                std::max(from.parameter, to.parameter));
      if (nearest.NbPoints() == 0) continue;
      const Vec3 there = vec(nearest.NearestPoint());
      if (std::min(distance(there, brep_.points[from.node]),
                   distance(there, brep_.points[to.node])) < kFaceMeshLimits.shortest)
        continue;
      cuts.insert({s.edge, s.index, nearest.LowerDistanceParameter()});
      any = true;
    }
    return any;
  }

  /// Adds cuts that keep the border from crossing itself. Two polylines with their nodes opposite
  /// each other do not cross, however near their curves are. Where they are opposite already the
  /// longer segment is halved, because the chords of two touching circles separate only where those
  /// of the wider one are no longer than the other's. Returns false where splitting does not help.
  bool find_cuts(const Border& border, std::set<Cut>& cuts) const {
    for (const auto& [i, j] : crossing_segments(border)) {
      const Border::Segment &s = border.segments[i], &t = border.segments[j];
      const bool opposite_t = find_opposite(s, t, cuts), opposite_s = find_opposite(t, s, cuts);
      if (opposite_t || opposite_s) continue;
      const bool first = can_split(s) && (!can_split(t) || length(s) >= length(t));
      const Border::Segment& longer = first ? s : t;
      if (!can_split(longer)) return false;
      const std::vector<EdgeNode>& chain = chains_[longer.edge];
      cuts.insert({longer.edge, longer.index,
                   0.5 * (chain[longer.index].parameter + chain[longer.index + 1].parameter)});
    }
    return true;
  }

  bool triangulate(int f) {
    const Border border = border_of(f);
    const BRepAdaptor_Surface surface(face_shape(brep_, f), /*Restriction=*/false);
    const std::vector<std::array<double, 2>> inner = interior(surface, border);
    const auto triangles = mesh_border(border, inner);
    if (!triangles) return false;
    const int n = static_cast<int>(border.corners.size());
    std::vector<int> node_of(inner.size(), -1);
    const auto node = [&](int corner) {
      if (corner < n) return border.corners[corner].node;
      int& number = node_of[corner - n];
      const auto& p = inner[corner - n];
      if (number < 0)
        number = add_point(brep_, surface.Value(p[0] / stretch_[0], p[1] / stretch_[1]));
      return number;
    };
    BrepFace& out = brep_.faces[f];
    out.triangles.clear();
    double area = 0;
    for (const auto& t : *triangles) {
      const int a = node(t[0]), b = node(t[1]), c = node(t[2]);
      if (a == b || b == c || c == a) continue;  // at a pole
      out.triangles.push_back({a, b, c});
      area += triangle_area(brep_.points[a], brep_.points[b], brep_.points[c]);
    }
    // The area of a sliver is not compared: chords may be off by as much as it is wide.
    return std::fabs(area - out.area) <= kAreaError * out.area || out.area < 1e-2;
  }

  /// Nodes inside of a doubly curved face, at some distance from its border, in its coordinates.
  std::vector<std::array<double, 2>> interior(const BRepAdaptor_Surface& surface,
                                              const Border& border) const {
    if (surface.GetType() == GeomAbs_Plane || is_ruled(surface)) return {};
    CGAL::Bbox_2 box;
    for (const Border::Corner& corner : border.corners) box += point2(corner.p).bbox();
    const double step_u = kFaceTurning * stretch_[0], step_v = kFaceTurning * stretch_[1];
    const double reach = 0.4 * std::min(step_u, step_v);
    const double nu = (box.xmax() - box.xmin()) / step_u, nv = (box.ymax() - box.ymin()) / step_v;
    if (!(nu * nv < kFaceMeshLimits.most_interior)) return {};
    std::vector<std::array<double, 2>> points;
    for (int i = 0; i < nu; ++i)
      for (int j = 0; j < nv; ++j) {
        // Rows shifted by half a step make better triangles.
        const Point2 p(box.xmin() + step_u * (i + (j % 2 == 0 ? 0.3 : 0.8)),
                       box.ymin() + step_v * (j + 0.45));
        const bool far = std::ranges::all_of(border.segments, [&](const Border::Segment& s) {
          return CGAL::squared_distance(
                     K::Segment_2(point2(border.corners[s.a].p), point2(border.corners[s.b].p)),
                     p) > reach * reach;
        });
        if (far && p.x() < box.xmax() && p.y() < box.ymax()) points.push_back({p.x(), p.y()});
      }
    return points;
  }

  Brep& brep_;
  EdgeChains& chains_;
  std::vector<std::vector<int>> faces_at_;
  std::array<double, 2> stretch_{};
};

}  // namespace

std::vector<int> mesh_faces(Brep& brep, EdgeChains& chains, const Run& run) {
  brep.points.clear();
  for (const BrepVertex& vertex : brep.vertices) brep.points.push_back(vertex.position);
  return FaceMesher(brep, chains).mesh_all(run);
}

bool mend_faces(Brep& brep, EdgeChains& chains, const std::vector<int>& bad) {
  return FaceMesher(brep, chains).mend(bad);
}

}  // namespace remeshd::kernel
