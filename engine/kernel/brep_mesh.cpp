#include <BRepAdaptor_Surface.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
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

#include "engine/base/error.h"
#include "engine/kernel/brep_shapes.h"

namespace remeshd::kernel {
namespace {

// Lengths are in kernel units: a model's diagonal is 128 to 256 of them.
//
// Angular deflections for BRepMesh, rad: neighbouring facets of a round face turn by half of that.
// The second is tried where the first fails; a third, finer one would take seconds on a torus.
constexpr std::array<double, 2> kMeshAngles{0.24, 0.1};
struct BrepMeshing {
  double deflection = 0.5;  ///< linear; so large that the angular deflection decides alone
  double near = 0.1;        ///< x a chord: smaller gaps at it are near; its sagitta is 0.015 x
  double minimum = 1e-3;    ///< least edge; with OCCT's default small holes become triangles
};
constexpr BrepMeshing kMesh;

void mesh(const TopoDS_Shape& shape, double angle, const Message_ProgressRange& range) {
  IMeshTools_Parameters parameters;
  parameters.Angle = angle;
  parameters.Deflection = kMesh.deflection;
  parameters.MinSize = kMesh.minimum;
  parameters.InParallel = false;
  BRepMesh_IncrementalMesh(shape, parameters, range);
}

std::array<int, 2> ordered(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// Whether the triangles of a face cover it once: no half-edge twice, and those without a partner
/// are the segments of its edges, all of them. Where two edges nearly touch their polylines may
/// cross, and the CAD kernel then leaves out or doubles triangles without a word.
bool sound(const BrepFace& face, const EdgeChains& chains) {
  std::vector<std::array<int, 2>> half_edges, rim, border;
  for (const auto& t : face.triangles)
    for (int i = 0; i < 3; ++i) half_edges.push_back({t[i], t[(i + 1) % 3]});
  std::ranges::sort(half_edges);
  if (std::ranges::adjacent_find(half_edges) != half_edges.end()) return false;
  for (const auto& [a, b] : half_edges)
    if (!std::ranges::binary_search(half_edges, std::array{b, a})) rim.push_back(ordered(a, b));
  for (const int e : face.edges) {
    if (std::ranges::count(face.edges, e) != 1) continue;  // a seam has the face on both sides
    for (std::size_t i = 0; i + 1 < chains[e].size(); ++i)
      border.push_back(ordered(chains[e][i].node, chains[e][i + 1].node));
  }
  std::ranges::sort(rim);
  std::ranges::sort(border);
  return rim == border;
}

/// Faces without a sound triangulation.
std::vector<int> bad_faces(const Brep& brep, const EdgeChains& chains) {
  std::vector<int> bad;
  for (int f = 0; f < static_cast<int>(brep.faces.size()); ++f)
    if (brep.faces[f].triangles.empty() || !sound(brep.faces[f], chains)) bad.push_back(f);
  return bad;
}

/// Splits a triangle, given by its sorted corners, at the point of its face nearest to its
/// centroid.
void split(Brep& brep, int f, const std::array<int, 3>& corners) {
  std::vector<std::array<int, 3>>& triangles = brep.faces[f].triangles;
  const auto at = std::ranges::find_if(triangles, [&](std::array<int, 3> t) {
    std::ranges::sort(t);
    return t == corners;
  });
  const auto [a, b, c] = *at;
  const Vec3 p = (brep.points[a] + brep.points[b] + brep.points[c]) / 3;
  const GeomAPI_ProjectPointOnSurf above({p.x, p.y, p.z}, BRep_Tool::Surface(face_shape(brep, f)));
  if (above.NbPoints() == 0) return;
  const int middle = add_point(brep, above.NearestPoint());
  *at = {a, b, middle};
  triangles.push_back({b, c, middle});
  triangles.push_back({c, a, middle});
}

/// Where several faces have a triangle with the same corners, as a shallow cap and the disc below
/// it may, splits these triangles on the curved faces so that at most one stays whole. Returns the
/// plane faces with a triangle that another plane face has too.
std::vector<int> part_touching(Brep& brep) {
  std::vector<std::pair<std::array<int, 3>, int>> all;  // nodes and face
  for (int f = 0; f < static_cast<int>(brep.faces.size()); ++f)
    for (std::array<int, 3> t : brep.faces[f].triangles) {
      std::ranges::sort(t);
      all.emplace_back(t, f);
    }
  std::ranges::sort(all);
  std::vector<int> bad;
  const auto round = [&](int face) {
    return BRepAdaptor_Surface(face_shape(brep, face), false).GetType() != GeomAbs_Plane;
  };
  auto whole = all.begin();  // of those with the same nodes the one that is not split
  for (auto next = all.begin(); next != all.end(); ++next) {
    const auto& [nodes, face] = *next;
    if (nodes != whole->first) whole = next;
    if (next == whole) continue;
    if (round(face)) {
      split(brep, face, nodes);
    } else if (round(whole->second)) {
      split(brep, whole->second, nodes);
      whole = next;
    } else {
      bad.push_back(face);
    }
  }
  return bad;
}

/// Whether a polyline comes so near to another that the gap is small against the chords. There our
/// own triangles are right but coarse, and meshes of the surface begin to intersect themselves.
bool nearly_touch(const Brep& brep, const EdgeChains& chains) {
  struct Chord {
    std::array<int, 2> nodes;
    int edge;
  };
  std::vector<Chord> chords;  // of round edges
  std::vector<std::vector<int>> edges_at(brep.points.size());
  for (int e = 0; e < static_cast<int>(chains.size()); ++e)
    for (std::size_t i = 0; i < chains[e].size(); ++i) {
      edges_at[chains[e][i].node].push_back(e);
      if (i > 0 && brep.edges[e].kind != BrepEdge::Kind::Line)
        chords.push_back({ordered(chains[e][i - 1].node, chains[e][i].node), e});
    }
  std::ranges::sort(chords, {}, &Chord::nodes);
  const auto apart = [&](int e, int other) {
    const auto& [a, b] = brep.edges[e].vertices;
    return e != other && std::ranges::count(brep.edges[other].vertices, a) == 0 &&
           std::ranges::count(brep.edges[other].vertices, b) == 0;
  };
  for (const BrepFace& face : brep.faces)
    for (const auto& t : face.triangles)
      for (int i = 0; i < 3; ++i) {
        const std::array<int, 2> side = ordered(t[i], t[(i + 1) % 3]);
        const auto chord = std::ranges::lower_bound(chords, side, {}, &Chord::nodes);
        if (chord == chords.end() || chord->nodes != side) continue;
        const std::vector<int>& others = edges_at[t[(i + 2) % 3]];
        if (others.empty() ||
            !std::ranges::all_of(others, [&](int other) { return apart(chord->edge, other); }))
          continue;
        const Vec3& p = brep.points[side[0]];
        const Vec3 along = brep.points[side[1]] - p;
        if (norm(cross(along, brep.points[t[(i + 2) % 3]] - p)) < kMesh.near * norm2(along))
          return true;
      }
  return false;
}

/// Takes over the CAD kernel's triangulation; faces at an edge share the nodes on it.
class NodeNumbers {
 public:
  explicit NodeNumbers(Brep& brep) : brep_(brep), chains_(brep.edges.size()) {
    brep.points.clear();
    for (const BrepVertex& vertex : brep.vertices) brep.points.push_back(vertex.position);
    for (BrepFace& face : brep.faces) face.triangles.clear();
  }

  void add_all() {
    for (int f = 0; f < static_cast<int>(brep_.faces.size()); ++f)
      if (!add_face(f, face_shape(brep_, f))) brep_.faces[f].triangles.clear();
  }

  EdgeChains& chains() { return chains_; }

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
      std::vector<EdgeNode>& chain = chains_[e];
      if (chain.empty()) {
        if (!polygon->HasParameters()) return false;
        chain.push_back({brep_.edges[e].vertices[0], polygon->Parameter(1)});
        for (int i = 2; i < n; ++i)
          chain.push_back(
              {add(mesh->Node(polygon->Node(i)).Transformed(location)), polygon->Parameter(i)});
        chain.push_back({brep_.edges[e].vertices[1], polygon->Parameter(n)});
      }
      if (static_cast<int>(chain.size()) != n) return false;
      for (int i = 1; i <= n; ++i) node[polygon->Node(i)] = chain[i - 1].node;
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

  int add(const gp_Pnt& p) { return add_point(brep_, p); }

  Brep& brep_;
  EdgeChains chains_;
};

/// A point of a face for an error message: the point of its edges that is nearest to its centroid,
/// because the centroid may lie off the face.
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

void keep(const EdgeChains& chains, Brep& brep) {
  for (std::size_t e = 0; e < chains.size(); ++e)
    for (const EdgeNode& node : chains[e]) brep.edges[e].chain.push_back(node.node);
}

}  // namespace

void triangulate(Brep& brep, const TopoDS_Shape& shape, double scale, const Run& run) {
  // First with our own polylines and interior nodes: they do nearly everywhere and take a tenth of
  // the CAD kernel's time. Where they fail, edges nearly touch, and the CAD kernel's are finer.
  EdgeChains own(brep.edges.size());
  std::vector<int> bad = mesh_faces(brep, own, run);
  if (bad.empty()) bad = bad_faces(brep, own);
  if (bad.empty() && !nearly_touch(brep, own) && part_touching(brep).empty())
    return keep(own, brep);
  for (const double angle : kMeshAngles) {
    if (angle != kMeshAngles.front()) BRepTools::Clean(shape);
    with_progress(run, [&](const Message_ProgressRange& range) { mesh(shape, angle, range); });
    NodeNumbers numbers(brep);
    numbers.add_all();
    bad = bad_faces(brep, numbers.chains());
    if (!bad.empty() &&
        (!mend_faces(brep, numbers.chains(), bad) || !bad_faces(brep, numbers.chains()).empty()))
      continue;
    bad = part_touching(brep);
    if (bad.empty()) return keep(numbers.chains(), brep);
  }
  throw error::kernel_failure("a face could not be triangulated",
                              place_on(brep, bad.front()) / scale);
}

}  // namespace remeshd::kernel
