#include "engine/boundary/cover/open_borders.h"

#include <cmath>
#include <iterator>

#include "engine/mesh/grouping.h"

namespace remeshd {

OpenBorders::OpenBorders(SurfaceMesh& mesh, const std::vector<Triangle>& walls,
                         const BoundaryModel& boundary, double shortest)
    : mesh_(mesh), boundary_(boundary), shortest_(shortest) {
  require_vertices();
  chains_ = edge_chains(boundary, mesh.supports, mesh.nodes);
  for (const FaceFacet& f : mesh.facets)
    for (int i = 0; i < 3; ++i) {
      const Side side = side_of(f.nodes[i], f.nodes[(i + 1) % 3]);
      sides_that_stay_.emplace_back(f.face, side);
      rigid_.push_back(side);
    }
  std::ranges::sort(sides_that_stay_);
  for (const Triangle& w : walls)
    for (int i = 0; i < 3; ++i) rigid_.push_back(side_of(w[i], w[(i + 1) % 3]));
  sort_unique(rigid_);
}

std::int32_t OpenBorders::add_node(const Support& support, const Vec3& near) {
  mesh_.nodes.push_back(project(boundary_, support, near));
  mesh_.supports.push_back(support);
  return static_cast<std::int32_t>(mesh_.nodes.size()) - 1;
}

void OpenBorders::require_vertices() {
  std::vector<std::uint8_t> has(boundary_.vertices.size(), 0);
  for (const Support& s : mesh_.supports)
    if (s.kind == Support::Kind::Vertex) has[s.entity] = 1;
  for (std::size_t v = 0; v < has.size(); ++v)
    if (has[v] == 0)
      add_node({Support::Kind::Vertex, static_cast<std::int32_t>(v)},
               boundary_.vertices[v].position);
}

int OpenBorders::times_kept(std::int32_t face, const Side& side) const {
  const auto [begin, end] = std::ranges::equal_range(sides_that_stay_, std::pair(face, side));
  return static_cast<int>(end - begin);
}

std::map<std::int32_t, std::vector<BorderSide>> OpenBorders::find() {
  std::map<std::int32_t, std::vector<BorderSide>> borders;
  links_.clear();
  for (std::size_t e = 0; e < chains_.size(); ++e)
    for (std::size_t k = 0; k + 1 < chains_[e].size(); ++k)
      links_[side_of(chains_[e][k].node, chains_[e][k + 1].node)] = static_cast<int>(e);
  for (const auto& [side, edge] : links_) {
    const std::vector<int>& faces = boundary_.edges[edge].faces;
    for (const int f : faces) {
      const int open = (faces.size() == 1 ? 2 : 1) - times_kept(f, side);
      if (open > 0) borders[f].push_back({side, edge, open});
    }
  }
  for (auto it = sides_that_stay_.begin(); it != sides_that_stay_.end();) {
    const auto next =
        std::find_if(it, sides_that_stay_.end(), [&](const auto& other) { return other != *it; });
    const auto& [face, side] = *it;
    const auto link = links_.find(side);
    const bool of_face =
        link != links_.end() && std::ranges::count(boundary_.edges[link->second].faces, face) > 0;
    if ((next - it) % 2 == 1 && !of_face) borders[face].push_back({side, -1, 1});
    it = next;
  }
  return borders;
}

double OpenBorders::length(const Side& side) const {
  return distance(mesh_.nodes[side.first], mesh_.nodes[side.second]);
}

bool OpenBorders::may_halve(const Side& side) const {
  return !std::ranges::binary_search(rigid_, side) && length(side) > shortest_;
}

bool OpenBorders::halve_link(const Side& side) {
  const auto found = links_.find(side);
  if (found == links_.end()) return false;
  const int e = found->second;
  std::vector<NodeOnEdge>& chain = chains_[e];
  const auto it = std::ranges::adjacent_find(chain, [&](const NodeOnEdge& a, const NodeOnEdge& b) {
    return side_of(a.node, b.node) == side;
  });
  if (it == chain.end()) return false;
  const BoundaryEdge& edge = boundary_.edges[e];
  const double at = 0.5 * (it->at + std::next(it)->at);
  const double all = polyline_length(edge);
  const std::int32_t node =
      add_node({Support::Kind::Edge, e}, point_at(edge, at > all ? at - all : at));
  chain.insert(std::next(it), {at, node});
  links_.erase(found);
  return true;
}

}  // namespace remeshd
