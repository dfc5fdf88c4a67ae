#include "engine/optimise/pull.h"

#include <algorithm>
#include <utility>

#include "engine/mesh/grouping.h"
#include "engine/nodes/nearest.h"

namespace remeshd {

namespace {

/// Cosine of 120 degrees: normals turned further apart leave a wedge of less than 60 degrees.
constexpr double kSharp = -0.5;

void tidy(std::vector<std::vector<int>>& sets) {
  for (auto& s : sets) sort_unique(s);
}

bool holds(const std::vector<std::vector<int>>& sets, int a, int b) {
  return std::binary_search(sets[a].begin(), sets[a].end(), b);
}

/// Whether the two faces of an edge meet in a wedge, of material or of void, of less than 60
/// degrees somewhere along their edge.
bool sharp_along(const BoundaryModel& boundary, const BoundaryEdge& edge) {
  const BoundaryFace &f = boundary.faces[edge.faces[0]], &g = boundary.faces[edge.faces[1]];
  return std::any_of(edge.points.begin(), edge.points.end(), [&](const Vec3& p) {
    return dot(outward_normal(f, p), outward_normal(g, p)) < kSharp;
  });
}

/// How the samples of one face or edge, `entity`, pull on one node: their weights and their
/// weighted positions, summed.
struct Pull {
  std::int32_t node;
  std::int32_t entity;
  double weight;
  Vec3 moment;
};

/// Sums up the pulls of the active samples, which are of faces alone or of edges alone; the result
/// is sorted by node, then entity. Appends to `pulling` the samples whose nearest node is free, in
/// reach or not.
std::vector<Pull> gather(const NodeSet& nodes, const Samples& samples,
                         std::span<const std::uint32_t> active, NearestToPoints& nearest,
                         const PullOptions& options, std::vector<std::uint32_t>& pulling,
                         const Run& run) {
  const std::vector<std::int32_t> nearest_node = nearest.nearest(active, run);
  const auto pulls_on = [&](std::int32_t node) { return node >= 0 && nodes.is_free(node); };
  const auto reaches = [&](std::uint32_t sample, std::int32_t node) {
    if (options.reach == HUGE_VAL) return true;
    const Vec3& p = samples.points[sample].position;
    const double least_size = distance(p, nodes.positions[node]) / options.reach;
    return least_size <= options.sizes.least() || !options.sizes.is_below(p, least_size);
  };
  std::vector<std::uint8_t> pulls_at(active.size());
  for (std::size_t k = 0; k < active.size(); ++k)
    pulls_at[k] = pulls_on(nearest_node[k]) && reaches(active[k], nearest_node[k]) ? 1 : 0;
  const auto samples_at = grouped<std::uint32_t>(nodes.positions.size(), [&](const auto& visit) {
    for (std::size_t k = 0; k < active.size(); ++k)
      if (pulls_at[k] != 0) visit(nearest_node[k], active[k]);
  });
  for (std::size_t k = 0; k < active.size(); ++k)
    if (pulls_on(nearest_node[k])) pulling.push_back(active[k]);
  std::vector<Pull> pulls;
  for (std::int32_t n = 0; n < nodes.size(); ++n) {
    const auto first = static_cast<std::ptrdiff_t>(pulls.size());
    for (const std::uint32_t index : samples_at[n]) {
      const Sample& s = samples.points[index];
      const auto known = std::find_if(pulls.begin() + first, pulls.end(),
                                      [&](const Pull& p) { return p.entity == s.support.entity; });
      if (known == pulls.end()) {
        pulls.push_back({n, s.support.entity, s.weight, s.weight * s.position});
      } else {
        known->weight += s.weight;
        known->moment += s.weight * s.position;
      }
    }
    std::sort(pulls.begin() + first, pulls.end(),
              [](const Pull& a, const Pull& b) { return a.entity < b.entity; });
  }
  return pulls;
}

Vec3 target(const BoundaryModel& boundary, Support support, const Pull& pull) {
  return project(boundary, support, pull.moment / pull.weight);
}

/// Moves every pulled node to the face or edge with the strongest pull on it. Each other one whose
/// pull is at least `split_ratio` of that gets a new node, unless the two meet bluntly, or sharply
/// with their places near each other.
void reposition(NodeSet& nodes, const BoundaryModel& boundary, const Adjacency& adjacency,
                Support::Kind kind, const std::vector<Pull>& pulls, const PullOptions& options) {
  for (std::size_t first = 0; first < pulls.size();) {
    std::size_t last = first;
    std::size_t strongest = first;
    for (; last < pulls.size() && pulls[last].node == pulls[first].node; ++last)
      if (pulls[last].weight > pulls[strongest].weight) strongest = last;
    const Pull& winner = pulls[strongest];
    nodes.supports[winner.node] = {kind, winner.entity};
    nodes.positions[winner.node] = target(boundary, nodes.supports[winner.node], winner);
    const Vec3 placed = nodes.positions[winner.node];
    for (std::size_t k = first; k < last && options.split; ++k) {
      if (k == strongest || pulls[k].weight < options.split_ratio * winner.weight) continue;
      const Meeting meeting = adjacency.meeting(kind, winner.entity, pulls[k].entity);
      if (meeting == Meeting::Blunt) continue;
      const Support support{kind, pulls[k].entity};
      const Vec3 place = target(boundary, support, pulls[k]);
      if (meeting == Meeting::Sharp &&
          distance(place, placed) < options.split_distance * options.sizes(placed))
        continue;
      nodes.add_new(place, support);
    }
    first = last;
  }
}

/// Puts a node at every active model vertex without one: the nearest within reach, even if fixed,
/// that is neither at another vertex nor at the patch's interface; else a new one.
void claim_vertices(NodeSet& nodes, const Samples& samples, std::span<const std::uint32_t> active,
                    const NearestNode& grid, const PullOptions& options) {
  std::vector<std::uint8_t> taken(nodes.size(), 0);
  for (std::int32_t n = 0; n < nodes.size(); ++n)
    taken[n] = !nodes.is_free(n) && nodes.supports[n].kind == Support::Kind::Vertex;
  for (const std::uint32_t index : active) {
    const Sample& s = samples.points[index];
    std::int32_t best = -1;
    double best_d = HUGE_VAL;
    bool done = false;
    grid.for_each_within(s.position, options.vertex_reach * options.sizes(s.position),
                         [&](std::int32_t n, double d) {
                           if (nodes.supports[n] == s.support && !nodes.is_free(n)) done = true;
                           if (taken[n] || n < nodes.interface_nodes) return;
                           if (d < best_d || (d == best_d && n < best)) {
                             best_d = d;
                             best = n;
                           }
                         });
    if (done) continue;
    if (best < 0) {
      nodes.add_new(s.position, s.support);
      continue;
    }
    taken[best] = 1;
    nodes.state[best] = NodeState::Free;
    nodes.positions[best] = s.position;
    nodes.supports[best] = s.support;
  }
}

}  // namespace

Adjacency::Adjacency(const BoundaryModel& boundary)
    : faces_(boundary.faces.size()),
      edges_(boundary.edges.size()),
      sharp_faces_(boundary.faces.size()),
      sharp_edges_(boundary.edges.size()) {
  const auto join = [](std::vector<std::vector<int>>& sets, int a, int b) {
    sets[a].push_back(b);
    sets[b].push_back(a);
  };
  for (const BoundaryEdge& edge : boundary.edges) {
    if (edge.faces.size() != 2) continue;
    join(faces_, edge.faces[0], edge.faces[1]);
    if (sharp_along(boundary, edge)) join(sharp_faces_, edge.faces[0], edge.faces[1]);
  }
  for (int v = 0; v < static_cast<int>(boundary.vertices.size()); ++v) {
    const auto& round = boundary.vertices[v].edges;
    for (std::size_t i = 0; i < round.size(); ++i)
      for (std::size_t j = i + 1; j < round.size(); ++j) {
        join(edges_, round[i], round[j]);
        const BoundaryEdge &a = boundary.edges[round[i]], &b = boundary.edges[round[j]];
        if (dot(a.leaving(a.start == v), b.leaving(b.start == v)) > -kSharp)
          join(sharp_edges_, round[i], round[j]);
      }
  }
  for (auto* sets : {&faces_, &edges_, &sharp_faces_, &sharp_edges_}) tidy(*sets);
}

Meeting Adjacency::meeting(Support::Kind kind, int a, int b) const {
  const bool face = kind == Support::Kind::Face;
  if (!holds(face ? faces_ : edges_, a, b)) return Meeting::Apart;
  return holds(face ? sharp_faces_ : sharp_edges_, a, b) ? Meeting::Sharp : Meeting::Blunt;
}

std::vector<std::uint32_t> pull_boundary(NodeSet& nodes, const BoundaryModel& boundary,
                                         const Adjacency& adjacency, const Samples& samples,
                                         std::span<const std::uint32_t> active,
                                         NearestToPoints& nearest, const PullOptions& options,
                                         const Run& run) {
  const auto edges = std::lower_bound(active.begin(), active.end(), samples.edges_begin);
  const auto vertices = std::lower_bound(edges, active.end(), samples.vertices_begin);
  std::vector<std::uint32_t> pulling;
  for (std::int32_t n = 0; n < nodes.size(); ++n)
    if (nodes.is_free(n)) nodes.supports[n] = {};
  const auto pull = [&](Support::Kind kind, std::span<const std::uint32_t> of) {
    nearest.follow(nodes.positions);
    const auto pulls = gather(nodes, samples, of, nearest, options, pulling, run);
    reposition(nodes, boundary, adjacency, kind, pulls, options);
  };
  pull(Support::Kind::Face, {active.begin(), edges});
  pull(Support::Kind::Edge, {edges, vertices});
  nearest.follow(nodes.positions);
  claim_vertices(nodes, samples, {vertices, active.end()}, nearest.grid_of_nodes(), options);
  pulling.insert(pulling.end(), vertices, active.end());
  return pulling;
}

}  // namespace remeshd
