#include "engine/optimise/recover.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

#include "engine/boundary/edge_chains.h"
#include "engine/mesh/grouping.h"

namespace remeshd {

namespace {

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

int fewest(const RecoverOptions& options, int edge) {
  return options.fewest_links.empty() ? 0 : options.fewest_links[edge];
}

/// As many of the longest links as a chain lacks, all of them at most, by the number of their
/// second node.
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

}  // namespace

int recover_edges(NodeSet& nodes, const BoundaryModel& boundary, LiveMesh& live,
                  const RecoverOptions& options) {
  const int most = 200 + static_cast<int>(options.most * nodes.size());
  int inserted = 0;
  for (int round = 0; round < options.rounds; ++round) {
    live.follow(nodes);
    const std::vector<Link> links = links_between_edge_nodes(nodes, live.mesh());
    const std::vector<std::vector<NodeOnEdge>> chain =
        edge_chains(boundary, nodes.supports, nodes.positions);
    const int before = inserted;
    for (int e = 0; e < static_cast<int>(chain.size()); ++e) {
      const BoundaryEdge& edge = boundary.edges[e];
      const double length = polyline_length(edge);
      const auto insert = [&](double at) {
        const double wrapped = at > length ? at - length : at;
        nodes.add_new(project(boundary, edge, point_at(edge, wrapped)), {Support::Kind::Edge, e});
        ++inserted;
      };
      // A closed edge needs three nodes to be a chain at all.
      const std::size_t nodes_on = chain[e].size() - (chain[e].empty() ? 0 : 1);
      // Between two interface nodes there may be others that are not in the patch.
      const auto at_rim = [&](const NodeOnEdge& on) { return on.node < nodes.interface_nodes; };
      const bool elsewhere =
          chain[e].empty() ? nodes.elsewhere > 0 && !std::ranges::binary_search(options.wanted, e)
                           : std::ranges::any_of(chain[e], at_rim);
      if (edge.closed() && nodes_on < 3 && !elsewhere) {
        const double from = chain[e].empty() ? 0 : chain[e].front().at;
        for (int k = chain[e].empty() ? 0 : 1; k < 3; ++k) insert(from + k * length / 3);
        continue;
      }
      const auto longest = longest_links(chain[e], elsewhere ? 0 : fewest(options, e));
      for (const std::size_t k : longest) insert(0.5 * (chain[e][k - 1].at + chain[e][k].at));
      if (!longest.empty()) continue;
      for (std::size_t k = 1; k < chain[e].size(); ++k) {
        const NodeOnEdge &a = chain[e][k - 1], &b = chain[e][k];
        if (at_rim(a) && at_rim(b)) continue;
        if (!std::binary_search(links.begin(), links.end(),
                                Link(std::min(a.node, b.node), std::max(a.node, b.node))))
          insert(split_at(nodes, a, b, options.sizes));
      }
    }
    if (inserted == before) return inserted;
    if (inserted > most) break;
  }
  live.follow(nodes);
  return inserted;
}

}  // namespace remeshd
