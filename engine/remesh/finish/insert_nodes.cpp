#include "engine/remesh/finish/insert_nodes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

#include "engine/boundary/edge_chains.h"
#include "engine/mesh/grouping.h"
#include "engine/nodes/nearest.h"
#include "engine/optimise/live_mesh.h"
#include "engine/remesh/finish/crowded_links.h"

namespace remeshd {

namespace {

struct RoomLimits {
  double around = 1.0;   ///< x edge length: how far from a defect samples are looked at
  double closest = 0.2;  ///< x edge length: no new node is nearer than this to another
};
constexpr RoomLimits kRoomLimits;

/// A closed edge needs as many nodes to be a chain at all.
constexpr int kFewestOfClosed = 3;

using Link = std::pair<std::int32_t, std::int32_t>;

/// Where to split the link from a to b: in the middle, or on the shell nearest to it round the one
/// end that is a model vertex.
double split_at(const NodeSet& nodes, const NodeOnEdge& a, const NodeOnEdge& b,
                const SizeField& sizes) {
  const double length = b.at - a.at;
  const bool from_a = nodes.supports[a.node].kind == Support::Kind::Vertex;
  const bool from_b = nodes.supports[b.node].kind == Support::Kind::Vertex;
  if (from_a == from_b) return a.at + 0.5 * length;
  const double edge_length = sizes(nodes.positions[from_a ? a.node : b.node]);
  const double shell = edge_length * std::exp2(std::round(std::log2(0.5 * length / edge_length)));
  return from_a ? a.at + shell : b.at - shell;
}

std::vector<Link> links_between_edge_nodes(const NodeSet& nodes, const DelaunayMesh& mesh) {
  std::vector<Link> links;
  const auto on_edge = [&](std::int32_t n) {
    return nodes.supports[n].kind >= Support::Kind::Edge;
  };
  mesh.for_each_tet([&](const DelaunayMesh::Corners& t) {
    for (int i = 0; i < 4; ++i) {
      if (!on_edge(t[i])) continue;
      for (int j = i + 1; j < 4; ++j)
        if (on_edge(t[j])) links.emplace_back(std::min(t[i], t[j]), std::max(t[i], t[j]));
    }
  });
  sort_unique(links);
  return links;
}

int fewest(const SegmentOptions& options, int edge) {
  return options.fewest_links.empty() ? 0 : options.fewest_links[edge];
}

/// The longest links of a chain, as many as it lacks or all that it has, each by the index of its
/// second node in the chain.
std::vector<std::size_t> longest_links(const std::vector<NodeOnEdge>& chain, int fewest) {
  if (chain.empty()) return {};
  const auto lacking = static_cast<std::ptrdiff_t>(fewest) - std::ssize(chain) + 1;
  if (lacking <= 0) return {};
  std::vector<std::size_t> links(chain.size() - 1);
  std::iota(links.begin(), links.end(), 1);
  std::ranges::stable_sort(links, std::ranges::greater(),
                           [&](std::size_t k) { return chain[k].at - chain[k - 1].at; });
  links.resize(std::min(links.size(), static_cast<std::size_t>(lacking)));
  return links;
}

/// By model edge: 1 where it is a single link between two vertices that a shorter model edge joins
/// by a single link too, as both sides of a lens-shaped face do. They would be one mesh edge.
std::vector<std::uint8_t> doubled_links(const BoundaryModel& boundary,
                                        const std::vector<std::vector<NodeOnEdge>>& chain) {
  std::vector<int> single;
  for (int e = 0; e < static_cast<int>(chain.size()); ++e)
    if (chain[e].size() == 2 && !boundary.edges[e].closed()) single.push_back(e);
  const auto ends = [&](int e) {
    return std::minmax(boundary.edges[e].start, boundary.edges[e].end);
  };
  std::ranges::stable_sort(single, [&](int a, int b) {
    return ends(a) != ends(b) ? ends(a) < ends(b)
                              : boundary.edges[a].length < boundary.edges[b].length;
  });
  std::vector<std::uint8_t> doubled(chain.size(), 0);
  for (std::size_t k = 1; k < single.size(); ++k)
    if (ends(single[k - 1]) == ends(single[k])) doubled[single[k]] = 1;
  return doubled;
}

/// `insert_in_segments` with a mesh that follows the nodes.
int insert_until_present(NodeSet& nodes, LiveMesh& live, const BoundaryModel& boundary,
                         const SegmentOptions& options) {
  const int most = 200 + static_cast<int>(options.most * nodes.size());
  // A chain's first node counts twice. Even meshes are to stay as older versions made them, which
  // put two more nodes at thirds beside two that were there, in one of their places at worst.
  const std::size_t most_anew = options.make_room ? 2 : 3;
  int inserted = 0;
  for (int round = 0; round < options.rounds; ++round) {
    live.follow(nodes);
    const std::vector<Link> links = links_between_edge_nodes(nodes, live.mesh());
    const std::vector<std::vector<NodeOnEdge>> chain =
        edge_chains(boundary, nodes.supports, nodes.positions);
    const std::vector<std::uint8_t> doubled = doubled_links(boundary, chain);
    const int before = inserted;
    std::optional<CrowdedLinks> crowded;
    for (int e = 0; e < static_cast<int>(chain.size()); ++e) {
      const BoundaryEdge& edge = boundary.edges[e];
      const double length = polyline_length(edge);
      const auto insert = [&](double at) {
        const double wrapped = at > length ? at - length : at;
        nodes.add_new(project(boundary, edge, point_at(edge, wrapped)), {Support::Kind::Edge, e});
        ++inserted;
      };
      // Between two interface nodes there may be others that are not in the patch.
      const auto at_rim = [&](const NodeOnEdge& on) { return on.node < nodes.interface_nodes; };
      const bool elsewhere =
          chain[e].empty() ? nodes.elsewhere > 0 && !std::ranges::binary_search(options.wanted, e)
                           : std::ranges::any_of(chain[e], at_rim);
      if (edge.closed() && chain[e].size() <= most_anew && !elsewhere) {
        const double from = chain[e].empty() ? 0 : chain[e].front().at;
        for (int k = chain[e].empty() ? 0 : 1; k < kFewestOfClosed; ++k)
          insert(from + k * length / kFewestOfClosed);
        continue;
      }
      const int least = std::max(fewest(options, e), edge.closed() ? kFewestOfClosed : 0);
      const auto longest = longest_links(chain[e], elsewhere ? 0 : least);
      for (const std::size_t k : longest) insert(0.5 * (chain[e][k - 1].at + chain[e][k].at));
      if (!longest.empty()) continue;
      if (doubled[e] != 0 && !elsewhere) {
        insert(0.5 * (chain[e][0].at + chain[e][1].at));
        continue;
      }
      for (std::size_t k = 1; k < chain[e].size(); ++k) {
        const NodeOnEdge &a = chain[e][k - 1], &b = chain[e][k];
        if (at_rim(a) && at_rim(b)) continue;
        if (std::binary_search(links.begin(), links.end(),
                               Link(std::min(a.node, b.node), std::max(a.node, b.node))))
          continue;
        if (options.make_room && !crowded) crowded.emplace(nodes, boundary, options.sizes);
        if (crowded && crowded->clear(e, a.node, b.node))
          ++inserted;
        else
          insert(split_at(nodes, a, b, options.sizes));
      }
    }
    if (inserted == before) return inserted;
    if (inserted > most) break;
  }
  live.follow(nodes);
  return inserted;
}

/// Places on the boundary that are not too near to a node or to each other.
class RoomForNodes {
 public:
  RoomForNodes(const NodeSet& nodes, const BoundaryModel& boundary, const Samples& samples,
               const SizeField& sizes)
      : nodes_(nodes),
        boundary_(boundary),
        samples_(samples),
        sizes_(sizes),
        cell_(kGridCell * sizes.grid_length()),
        grid_of_nodes_(nodes.positions, cell_),
        grid_of_samples_(samples.positions(), cell_),
        grid_of_taken_(places_, cell_),
        sample_to_node2_(samples.points.size(), -1) {}

  /// Whether there is room in the middle of a missing segment.
  [[nodiscard]] bool has_room_in_middle(const MeshDefect& missing) const {
    const Vec3 middle = middle_of(missing);
    return to_taken2(middle, to_node2(middle)) > closest2(missing.place);
  }

  /// Takes the middle of a missing segment that has room there; for other defects the sample near
  /// the defect that is farthest from any node, or nothing where that has no room.
  void take_place_for(const MeshDefect& defect) {
    if (defect.kind == MeshFailure::MissingSegment && has_room_in_middle(defect))
      return take({middle_of(defect), 0, {Support::Kind::Edge, defect.entity}});
    const double edge_length = sizes_(defect.place);
    std::vector<std::int32_t> near;
    grid_of_samples_.for_each_within(defect.place, kRoomLimits.around * edge_length,
                                     [&](std::int32_t s, double) { near.push_back(s); });
    std::ranges::sort(near);
    std::int32_t best = -1;
    double farthest = closest2(defect.place);
    for (const std::int32_t s : near) {
      const double d = room2(s, farthest);
      if (d <= farthest) continue;
      farthest = d;
      best = s;
    }
    if (best >= 0) take(samples_.points[best]);
  }

  [[nodiscard]] const std::vector<Sample>& taken() const { return taken_; }

 private:
  [[nodiscard]] Vec3 middle_of(const MeshDefect& missing) const {
    return project(boundary_, {Support::Kind::Edge, missing.entity}, missing.place);
  }
  /// Square of the least distance between nodes at a place.
  [[nodiscard]] double closest2(const Vec3& place) const {
    const double closest = kRoomLimits.closest * sizes_(place);
    return closest * closest;
  }

  /// Square of the distance of a sample to what is nearest to it, where that is more than `enough`.
  double room2(std::int32_t sample, double enough) {
    const Vec3& p = samples_.points[sample].position;
    double& of_nodes = sample_to_node2_[sample];
    if (of_nodes < 0) of_nodes = to_node2(p);
    return of_nodes <= enough ? of_nodes : to_taken2(p, of_nodes);
  }
  [[nodiscard]] double to_node2(const Vec3& p) const {
    return norm2(p - nodes_.positions[grid_of_nodes_.nearest(p)]);
  }
  /// Square of the distance to the nearest place that was taken, but at most `most2`.
  [[nodiscard]] double to_taken2(const Vec3& p, double most2) const {
    const std::int32_t other = grid_of_taken_.nearest(p);
    return other < 0 ? most2 : std::fmin(most2, norm2(p - places_[other]));
  }

  void take(const Sample& sample) {
    taken_.push_back(sample);
    places_.push_back(sample.position);
    const auto last = static_cast<std::int32_t>(places_.size()) - 1;
    grid_of_taken_.follow(places_, {&last, 1});
  }

  const NodeSet& nodes_;
  const BoundaryModel& boundary_;
  const Samples& samples_;
  const SizeField& sizes_;
  std::vector<Sample> taken_;
  std::vector<Vec3> places_;  ///< positions of those taken
  double cell_;
  const NearestNode grid_of_nodes_, grid_of_samples_;
  NearestNode grid_of_taken_;
  std::vector<double> sample_to_node2_;  ///< by sample: squared, to the nearest node; -1: not known
};

/// Gives a model vertex on which no node stands the nearest one, where that is no vertex's own and
/// nearer than a new node may be, else a new one. Returns whether it had none.
bool give_node(NodeSet& nodes, const NearestNode& grid, int vertex, const BoundaryModel& boundary,
               const SizeField& sizes) {
  const Support on{Support::Kind::Vertex, vertex};
  if (std::ranges::find(nodes.supports, on) != nodes.supports.end()) return false;
  const Vec3& place = boundary.vertices[vertex].position;
  const std::int32_t nearest = grid.nearest(place);
  if (nearest >= nodes.interface_nodes && nodes.supports[nearest].kind != on.kind &&
      distance(nodes.positions[nearest], place) < kRoomLimits.closest * sizes(place)) {
    nodes.positions[nearest] = place;
    nodes.supports[nearest] = on;
    nodes.state[nearest] = NodeState::Free;
  } else {
    nodes.add_new(place, on);
  }
  return true;
}

}  // namespace

int insert_in_segments(NodeSet& nodes, DelaunayMesh& mesh, std::int32_t in_mesh,
                       const BoundaryModel& boundary, const SegmentOptions& options,
                       const Run& run) {
  std::vector<std::uint8_t> holds(nodes.positions.size(), 0);
  std::fill_n(holds.begin(), in_mesh, 1);
  LiveMesh live(std::move(mesh), std::move(holds), false, run);
  const int inserted = insert_until_present(nodes, live, boundary, options);
  mesh = live.mesh();
  return inserted;
}

int insert_where_missing(NodeSet& nodes, std::span<const MeshDefect> defects,
                         const BoundaryModel& boundary, const Samples& samples,
                         const SizeField& sizes, bool make_room) {
  if (nodes.positions.empty()) return 0;  // an empty patch
  int changed = 0;
  const NearestNode grid(nodes.positions, kGridCell * sizes.grid_length());
  for (const MeshDefect& defect : defects)
    if (defect.kind == MeshFailure::MissingVertex &&
        give_node(nodes, grid, defect.entity, boundary, sizes))
      ++changed;
  RoomForNodes room(nodes, boundary, samples, sizes);
  std::vector<MeshDefect> crowded;
  for (const MeshDefect& defect : defects)
    if (make_room && defect.kind == MeshFailure::MissingSegment && !room.has_room_in_middle(defect))
      crowded.push_back(defect);
    else
      room.take_place_for(defect);
  if (!crowded.empty()) {
    CrowdedLinks links(nodes, boundary, sizes);
    for (const MeshDefect& defect : crowded)
      if (links.clear(defect))
        ++changed;
      else
        room.take_place_for(defect);
  }
  for (const Sample& s : room.taken()) nodes.add_new(s.position, s.support);
  return changed + static_cast<int>(room.taken().size());
}

}  // namespace remeshd
