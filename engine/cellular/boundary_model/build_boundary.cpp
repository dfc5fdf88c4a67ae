#include "engine/cellular/boundary_model/build_boundary.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/cellular/boundary_model/edge_curve.h"
#include "engine/cellular/boundary_model/tolerant_order.h"
#include "engine/mesh/grouping.h"

namespace remeshd {
namespace {

using kernel::Brep;
using kernel::BrepEdge;

/// Sorts `values` by `keys` and returns for each old index the new one.
template <typename T, typename Key>
std::vector<int> sort_by(std::vector<T>& values, const std::vector<Key>& keys) {
  std::vector<int> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int i) -> const Key& { return keys[i]; });
  return rearrange(values, order);
}

/// One use of a B-rep edge in a chain.
struct Step {
  int edge;
  bool backward;
};

/// Joins unified edges into chains through B-rep vertices that are not unified, each chain once.
std::vector<std::vector<Step>> find_chains(const Brep& brep, const UnifiedEdges& unified) {
  std::vector<std::vector<int>> at_vertex(brep.vertices.size());
  const int n = static_cast<int>(brep.edges.size());
  for (int e = 0; e < n; ++e)
    if (unified.edge[e])
      for (const int v : brep.edges[e].vertices) at_vertex[v].push_back(e);

  std::vector<char> used(brep.edges.size(), 0);
  const auto walk = [&](int edge, bool backward) {
    std::vector<Step> chain;
    for (int e = edge; e >= 0;) {
      used[e] = 1;
      chain.push_back({e, backward});
      const int to = brep.edges[e].vertices[backward ? 0 : 1];
      if (unified.vertex[to]) break;
      int next = -1;
      for (const int candidate : at_vertex[to])
        if (!used[candidate]) next = candidate;
      if (next >= 0) backward = brep.edges[next].vertices[0] != to;
      e = next;
    }
    return chain;
  };
  std::vector<std::vector<Step>> chains;
  for (int e = 0; e < n; ++e)
    for (const bool backward : {false, true})
      if (unified.edge[e] && !used[e] && unified.vertex[brep.edges[e].vertices[backward ? 1 : 0]])
        chains.push_back(walk(e, backward));
  // What is left are loops without a vertex.
  for (int e = 0; e < n; ++e)
    if (unified.edge[e] && !used[e]) chains.push_back(walk(e, false));
  return chains;
}

BoundaryEdge join(const Brep& brep, const std::vector<Step>& chain) {
  BoundaryEdge out;
  bool lines = true, circles = true;
  for (const auto& [e, backward] : chain) {
    const BrepEdge& edge = brep.edges[e];
    lines = lines && edge.kind == BrepEdge::Kind::Line;
    circles = circles && edge.kind == BrepEdge::Kind::Circle;
    out.length += edge.length;
    std::vector<Vec3> points = edge.points;
    if (backward) std::reverse(points.begin(), points.end());
    out.points.insert(out.points.end(), points.begin() + (out.points.empty() ? 0 : 1),
                      points.end());
  }
  const BrepEdge& first = brep.edges[chain.front().edge];
  if (lines) {
    out.curve.kind = Curve::Kind::Line;
  } else if (circles) {
    out.curve.kind = Curve::Kind::Circle;
    out.curve.origin = first.centre;
    out.curve.direction = chain.front().backward ? -first.axis : first.axis;
    out.curve.radius = first.radius;
  }
  return out;
}

void add_edges(BoundaryModel& model, const Brep& brep, const UnifiedEdges& unified,
               const std::vector<int>& vertex_number, std::vector<std::vector<int>>& edges_of_group,
               std::vector<std::array<int, 2>>& groups_of_edge) {
  for (const std::vector<Step>& chain : find_chains(brep, unified)) {
    BoundaryEdge edge = join(brep, chain);
    const auto end = [&](const Step& step, bool last) {
      return vertex_number[brep.edges[step.edge].vertices[step.backward == last ? 0 : 1]];
    };
    edge.start = end(chain.front(), false);
    edge.end = end(chain.back(), true);
    if (edge.start >= 0) edge.points.front() = model.vertices[edge.start].position;
    if (edge.end >= 0) edge.points.back() = model.vertices[edge.end].position;
    edge.rim = unified.rim[chain.front().edge] != 0;
    make_canonical(edge);
    const auto& at = unified.faces_at_edge[chain.front().edge];
    groups_of_edge.push_back({unified.face_group[at.front()], unified.face_group[at.back()]});
    model.edges.push_back(std::move(edge));
  }
  const double gap = kOrderGap * kernel_tolerance(brep);
  std::vector<std::array<double, 6>> keys;
  for (const BoundaryEdge& edge : model.edges) {
    const Vec3& m = edge.points[edge.points.size() / 2];
    // Vertex numbers, spread by more than the gap, so that no two get the same rank.
    keys.push_back({m.x, m.y, m.z, 2 * gap * edge.start, 2 * gap * edge.end, edge.length});
  }
  const std::vector<int> renumber = sort_by(model.edges, tolerant_ranks(keys, gap));
  std::vector<std::array<int, 2>> sorted_groups(groups_of_edge.size());
  for (std::size_t i = 0; i < renumber.size(); ++i) sorted_groups[renumber[i]] = groups_of_edge[i];
  groups_of_edge = std::move(sorted_groups);
  for (int e = 0; e < static_cast<int>(model.edges.size()); ++e) {
    for (const int g : groups_of_edge[e]) edges_of_group[g].push_back(e);
    for (const int v : {model.edges[e].start, model.edges[e].end})
      if (v >= 0) model.vertices[v].edges.push_back(e);
  }
}

/// Joins pieces into faces. Each face gets its own numbering of points.
class FaceJoiner {
 public:
  FaceJoiner(const Brep& brep, const std::vector<BoundaryPiece>& pieces)
      : brep_(brep),
        pieces_(pieces),
        local_(brep.points.size()),
        used_for_(brep.points.size(), -1) {}

  /// `moment` becomes the area times the centroid.
  BoundaryFace join(const std::vector<int>& members, Vec3& moment) {
    ++face_;
    BoundaryFace face;
    std::vector<const BoundaryPiece*> joined;
    for (const int f : members) {
      joined.push_back(&pieces_[f]);
      face.area += brep_.faces[f].area;
      moment += brep_.faces[f].area * brep_.faces[f].centroid;
      add_triangles(f, face);
    }
    face.names = ordered_names(joined);
    // The surface of the first piece whose first name is also that of the whole face.
    face.surface = (*std::ranges::find_if(joined, [&](const BoundaryPiece* piece) {
                     return ordered_names({piece}).front() == face.names.front();
                   }))->surface;
    return face;
  }

 private:
  void add_triangles(int f, BoundaryFace& face) {
    for (std::array<int, 3> triangle : brep_.faces[f].triangles) {
      for (int& p : triangle) {
        if (used_for_[p] != face_) {
          used_for_[p] = face_;
          local_[p] = static_cast<int>(face.points.size());
          face.points.push_back(brep_.points[p]);
        }
        p = local_[p];
      }
      if (!pieces_[f].outward) std::swap(triangle[1], triangle[2]);
      face.triangles.push_back(triangle);
    }
  }

  const Brep& brep_;
  const std::vector<BoundaryPiece>& pieces_;
  std::vector<int> local_;     ///< point of the B-rep to point of the face
  std::vector<int> used_for_;  ///< by point of the B-rep: the last face that has it
  int face_ = -1;
};

bool is_reversed(const BoundaryFace& face) {
  double most = 0;
  bool reversed = false;
  for (const auto& [a, b, c] : face.triangles) {
    const Vec3 n = cross(face.points[b] - face.points[a], face.points[c] - face.points[a]);
    if (norm(n) <= most) continue;
    most = norm(n);
    const Vec3 centre = (face.points[a] + face.points[b] + face.points[c]) / 3;
    reversed = dot(n, normal(face.surface, centre)) < 0;
  }
  return reversed;
}

}  // namespace

std::vector<FaceName> ordered_names(const std::vector<const BoundaryPiece*>& pieces) {
  std::vector<FaceName> names;
  const auto add = [&](const std::vector<FaceName> BoundaryPiece::*side) {
    std::vector<const FaceName*> list;
    for (const BoundaryPiece* piece : pieces)
      for (const FaceName& name : piece->*side) list.push_back(&name);
    std::ranges::sort(list, [](const FaceName* a, const FaceName* b) {
      return a->feature != b->feature ? a->feature > b->feature : a->face < b->face;
    });
    const auto first = static_cast<std::ptrdiff_t>(names.size());
    for (const FaceName* name : list)
      if ((names.size() == static_cast<std::size_t>(first) || names.back() != *name) &&
          std::find(names.begin(), names.begin() + first, *name) == names.begin() + first)
        names.push_back(*name);
  };
  add(&BoundaryPiece::material_names);
  add(&BoundaryPiece::other_names);
  return names;
}

BoundaryModel build_boundary(const Brep& brep, const std::vector<BoundaryPiece>& pieces,
                             const UnifiedEdges& unified) {
  BoundaryModel model;
  const double tolerance = kernel_tolerance(brep);
  // The B-rep orders its vertices by position already.
  std::vector<int> vertex_number(brep.vertices.size(), -1);
  for (std::size_t v = 0; v < brep.vertices.size(); ++v)
    if (unified.vertex[v]) {
      vertex_number[v] = static_cast<int>(model.vertices.size());
      model.vertices.push_back({brep.vertices[v].position, {}});
    }
  std::vector<std::vector<int>> edges_of_group(unified.groups);
  std::vector<std::array<int, 2>> groups_of_edge;
  add_edges(model, brep, unified, vertex_number, edges_of_group, groups_of_edge);
  for (BoundaryVertex& vertex : model.vertices) sort_unique(vertex.edges);

  std::vector<std::vector<int>> members(unified.groups);
  for (int f = 0; f < static_cast<int>(pieces.size()); ++f)
    if (unified.face_group[f] >= 0) members[unified.face_group[f]].push_back(f);
  FaceJoiner joiner(brep, pieces);
  std::vector<std::array<double, 4>> measures;
  for (int g = 0; g < unified.groups; ++g) {
    Vec3 moment;
    BoundaryFace face = joiner.join(members[g], moment);
    face.edges = edges_of_group[g];
    face.edges.erase(std::unique(face.edges.begin(), face.edges.end()), face.edges.end());
    face.reversed = is_reversed(face);
    const Vec3 centroid = moment / face.area;
    measures.push_back({centroid.x, centroid.y, centroid.z, std::sqrt(face.area)});
    model.faces.push_back(std::move(face));
  }
  const auto ranks = tolerant_ranks(measures, kOrderGap * tolerance);
  std::vector<std::pair<std::array<int, 4>, std::vector<int>>> keys;
  for (int g = 0; g < unified.groups; ++g) keys.emplace_back(ranks[g], model.faces[g].edges);
  const std::vector<int> renumber = sort_by(model.faces, keys);
  for (std::size_t e = 0; e < model.edges.size(); ++e) {
    auto& faces = model.edges[e].faces;
    for (const int g : groups_of_edge[e]) faces.push_back(renumber[g]);
    sort_unique(faces);
  }
  refine(model, tolerance);
  for (const BoundaryFace& face : model.faces)
    for (const Vec3& p : face.points) model.bounds.add(p);
  return model;
}

}  // namespace remeshd
