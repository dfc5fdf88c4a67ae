#include "engine/cellular/build_boundary.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numbers>

#include "engine/cellular/edge_curve.h"

namespace remeshd {
namespace {

using kernel::Brep;
using kernel::BrepEdge;

using Key = std::vector<std::int64_t>;

/// Orders by position, with noise rounded away; the offset keeps round values off the borders.
Key position_key(const Vec3& p, double tolerance) {
  Key key;
  for (const double c : {p.x, p.y, p.z})
    key.push_back(static_cast<std::int64_t>(std::floor(c / (10 * tolerance) + 0.37)));
  return key;
}

/// Sorts `values` by `keys` and returns for each old index the new one.
template <typename T>
std::vector<int> sort_by(std::vector<T>& values, const std::vector<Key>& keys) {
  std::vector<int> order(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return keys[a] < keys[b]; });
  std::vector<T> sorted;
  std::vector<int> renumber(values.size());
  for (const int i : order) {
    renumber[i] = static_cast<int>(sorted.size());
    sorted.push_back(std::move(values[i]));
  }
  values = std::move(sorted);
  return renumber;
}

/// One use of a B-rep edge in a chain.
struct Step {
  int edge;
  bool backward;
};

/// Joins real edges through points that are no vertices, each chain once.
std::vector<std::vector<Step>> find_chains(const Brep& brep, const Skeleton& skeleton) {
  std::vector<std::vector<int>> at_vertex(brep.vertices.size());
  const int n = static_cast<int>(brep.edges.size());
  for (int e = 0; e < n; ++e)
    if (skeleton.edge[e])
      for (const int v : brep.edges[e].vertices) at_vertex[v].push_back(e);

  std::vector<char> used(brep.edges.size(), 0);
  const auto walk = [&](int edge, bool backward) {
    std::vector<Step> chain;
    for (int e = edge; e >= 0;) {
      used[e] = 1;
      chain.push_back({e, backward});
      const int to = brep.edges[e].vertices[backward ? 0 : 1];
      if (skeleton.vertex[to]) break;
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
      if (skeleton.edge[e] && !used[e] && skeleton.vertex[brep.edges[e].vertices[backward ? 1 : 0]])
        chains.push_back(walk(e, backward));
  // What is left are loops without a vertex.
  for (int e = 0; e < n; ++e)
    if (skeleton.edge[e] && !used[e]) chains.push_back(walk(e, false));
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

void add_edges(BoundaryModel& model, const Brep& brep, const Skeleton& skeleton,
               const std::vector<int>& vertex_number, std::vector<std::vector<int>>& edges_of_group,
               std::vector<std::array<int, 2>>& groups_of_edge) {
  for (const std::vector<Step>& chain : find_chains(brep, skeleton)) {
    BoundaryEdge edge = join(brep, chain);
    const auto end = [&](const Step& step, bool last) {
      return vertex_number[brep.edges[step.edge].vertices[step.backward == last ? 0 : 1]];
    };
    edge.start = end(chain.front(), false);
    edge.end = end(chain.back(), true);
    if (edge.start >= 0) edge.points.front() = model.vertices[edge.start].position;
    if (edge.end >= 0) edge.points.back() = model.vertices[edge.end].position;
    make_canonical(edge);
    const auto& at = skeleton.faces_at_edge[chain.front().edge];
    groups_of_edge.push_back({skeleton.face_group[at.front()], skeleton.face_group[at.back()]});
    model.edges.push_back(std::move(edge));
  }
  std::vector<Key> keys;
  const double tolerance = kernel_tolerance(brep);
  for (const BoundaryEdge& edge : model.edges) {
    Key key = position_key(edge.points[edge.points.size() / 2], tolerance);
    key.push_back(edge.start);
    key.push_back(edge.end);
    key.push_back(position_key({edge.length, 0, 0}, tolerance)[0]);
    keys.push_back(std::move(key));
  }
  const std::vector<int> renumber = sort_by(model.edges, keys);
  std::vector<std::array<int, 2>> sorted_groups(groups_of_edge.size());
  for (std::size_t i = 0; i < renumber.size(); ++i) sorted_groups[renumber[i]] = groups_of_edge[i];
  groups_of_edge = std::move(sorted_groups);
  for (int e = 0; e < static_cast<int>(model.edges.size()); ++e) {
    for (const int g : groups_of_edge[e]) edges_of_group[g].push_back(e);
    for (const int v : {model.edges[e].start, model.edges[e].end})
      if (v >= 0) model.vertices[v].edges.push_back(e);
  }
}

/// Names of all pieces of a face, the latest owner on the material side first.
std::vector<FaceName> ordered_names(const std::vector<FaceName>& material,
                                    const std::vector<FaceName>& other) {
  std::vector<FaceName> names;
  const auto add = [&](std::vector<FaceName> list) {
    std::sort(list.begin(), list.end(), [](const FaceName& a, const FaceName& b) {
      return a.feature != b.feature ? a.feature > b.feature : a.face < b.face;
    });
    for (FaceName& name : list)
      if (std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(std::move(name));
  };
  add(material);
  add(other);
  return names;
}

struct FaceParts {
  BoundaryFace face;
  std::vector<FaceName> material, other;
  Vec3 moment;
  std::map<int, int> local;  ///< point of the B-rep to point of the face
};

void add_piece(FaceParts& parts, const Brep& brep, int f, const BoundaryPiece& piece) {
  BoundaryFace& face = parts.face;
  const auto first_name = [](const BoundaryPiece& p) {
    return ordered_names(p.material_names, p.other_names).front();
  };
  const std::vector<FaceName> so_far = ordered_names(parts.material, parts.other);
  parts.material.insert(parts.material.end(), piece.material_names.begin(),
                        piece.material_names.end());
  parts.other.insert(parts.other.end(), piece.other_names.begin(), piece.other_names.end());
  // The surface of the piece that gives the whole face its first name.
  if (so_far.empty() || (ordered_names(parts.material, parts.other).front() != so_far.front() &&
                         ordered_names(parts.material, parts.other).front() == first_name(piece)))
    face.surface = piece.surface;
  face.area += brep.faces[f].area;
  parts.moment += brep.faces[f].area * brep.faces[f].centroid;
  for (std::array<int, 3> triangle : brep.faces[f].triangles) {
    for (int& p : triangle) {
      const auto [it, fresh] = parts.local.emplace(p, static_cast<int>(face.points.size()));
      if (fresh) face.points.push_back(brep.points[p]);
      p = it->second;
    }
    if (!piece.outward) std::swap(triangle[1], triangle[2]);
    face.triangles.push_back(triangle);
  }
}

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

BoundaryModel build_boundary(const Brep& brep, const std::vector<BoundaryPiece>& pieces,
                             const Skeleton& skeleton) {
  BoundaryModel model;
  const double tolerance = kernel_tolerance(brep);
  // The B-rep orders its vertices by position already.
  std::vector<int> vertex_number(brep.vertices.size(), -1);
  for (std::size_t v = 0; v < brep.vertices.size(); ++v)
    if (skeleton.vertex[v]) {
      vertex_number[v] = static_cast<int>(model.vertices.size());
      model.vertices.push_back({brep.vertices[v].position, {}});
    }
  std::vector<std::vector<int>> edges_of_group(skeleton.groups);
  std::vector<std::array<int, 2>> groups_of_edge;
  add_edges(model, brep, skeleton, vertex_number, edges_of_group, groups_of_edge);
  for (BoundaryVertex& vertex : model.vertices) {
    std::sort(vertex.edges.begin(), vertex.edges.end());
    vertex.edges.erase(std::unique(vertex.edges.begin(), vertex.edges.end()), vertex.edges.end());
  }

  std::vector<FaceParts> parts(skeleton.groups);
  for (int f = 0; f < static_cast<int>(pieces.size()); ++f)
    if (skeleton.face_group[f] >= 0) add_piece(parts[skeleton.face_group[f]], brep, f, pieces[f]);
  std::vector<Key> keys;
  for (int g = 0; g < skeleton.groups; ++g) {
    BoundaryFace& face = parts[g].face;
    face.edges = edges_of_group[g];
    face.edges.erase(std::unique(face.edges.begin(), face.edges.end()), face.edges.end());
    face.names = ordered_names(parts[g].material, parts[g].other);
    face.reversed = is_reversed(face);
    Key key = position_key(parts[g].moment / face.area, tolerance);
    key.push_back(position_key({face.area, 0, 0}, tolerance)[0]);
    key.insert(key.end(), face.edges.begin(), face.edges.end());
    keys.push_back(std::move(key));
    model.faces.push_back(std::move(face));
  }
  const std::vector<int> renumber = sort_by(model.faces, keys);
  for (std::size_t e = 0; e < model.edges.size(); ++e) {
    auto& faces = model.edges[e].faces;
    for (const int g : groups_of_edge[e]) faces.push_back(renumber[g]);
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  }
  refine(model, tolerance);
  for (const BoundaryFace& face : model.faces)
    for (const Vec3& p : face.points) model.bounds.add(p);
  return model;
}

}  // namespace remeshd
