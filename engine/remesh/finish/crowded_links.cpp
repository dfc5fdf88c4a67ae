#include "engine/remesh/finish/crowded_links.h"

#include <algorithm>
#include <cmath>

namespace remeshd {

namespace {
constexpr double kLeastPart = 0.25;  // of a link: a node on it is no nearer to its ends
constexpr double kShortest = 0.06;   // x edge length: a link that is shorter gets no node
}  // namespace

CrowdedLinks::CrowdedLinks(NodeSet& nodes, const BoundaryModel& boundary, const SizeField& sizes)
    : nodes_(nodes),
      boundary_(boundary),
      sizes_(sizes),
      grid_(nodes.positions, kGridCell * sizes.grid_length()),
      chains_(edge_chains(boundary, nodes.supports, nodes.positions)),
      changed_(nodes.positions.size(), 0) {}

bool CrowdedLinks::clear(std::int32_t edge, std::int32_t a, std::int32_t b) {
  if (changed_[a] != 0 || changed_[b] != 0) return true;  // the link has changed already
  const Link link = link_between(edge, a, b);
  if (link.length == 0) return false;
  const std::int32_t node = in_the_way(link);
  return node >= 0 && clear(link, node);
}

bool CrowdedLinks::clear(const MeshDefect& missing) {
  const auto& chain = chains_[missing.entity];
  for (std::size_t k = 1; k < chain.size(); ++k) {
    const Link link = link_between(missing.entity, chain[k - 1].node, chain[k].node);
    if (link.length == 0 || middle_of(link) != missing.place) continue;
    const std::int32_t node = in_the_way(link);
    return node >= 0 ? clear(link, node) : split(link, 0.5);
  }
  return false;
}

CrowdedLinks::Link CrowdedLinks::link_between(std::int32_t edge, std::int32_t a,
                                              std::int32_t b) const {
  return {edge, a, b, distance(nodes_.positions[a], nodes_.positions[b])};
}

std::optional<Vec3> CrowdedLinks::place_on(const Link& link, double part) const {
  const Vec3 &a = nodes_.positions[link.a], &b = nodes_.positions[link.b];
  const Vec3 place = project(boundary_, {Support::Kind::Edge, link.edge}, a + part * (b - a));
  const double nearer = std::fmin(distance(place, a), distance(place, b));
  const double farther = std::fmax(distance(place, a), distance(place, b));
  if (nearer < 0.5 * kLeastPart * link.length || farther > link.length) return {};
  return place;
}

bool CrowdedLinks::clear(const Link& link, std::int32_t node) {
  const bool on_edge = nodes_.supports[node].kind >= Support::Kind::Edge;
  return on_edge ? set_opposite(link, node) : move_onto(link, node);
}

bool CrowdedLinks::split(const Link& link, double part) {
  const std::optional<Vec3> place = place_on(link, part);
  if (!place || link.length < kShortest * sizes_(*place)) return false;
  nodes_.add_new(*place, {Support::Kind::Edge, link.edge});
  return true;
}

std::int32_t CrowdedLinks::in_the_way(const Link& link) const {
  std::int32_t best = -1;
  double nearest = HUGE_VAL;
  grid_.for_each_within(middle_of(link), 0.5 * link.length, [&](std::int32_t n, double d) {
    if (n < nodes_.interface_nodes || n == link.a || n == link.b || changed_[n] != 0) return;
    if (d > nearest || (d == nearest && n > best)) return;
    best = n;
    nearest = d;
  });
  return best;
}

bool CrowdedLinks::move_onto(const Link& link, std::int32_t node) {
  const Vec3 &a = nodes_.positions[link.a], &b = nodes_.positions[link.b];
  const double at = dot(nodes_.positions[node] - a, b - a) / (link.length * link.length);
  const std::optional<Vec3> place = place_on(link, std::clamp(at, kLeastPart, 1 - kLeastPart));
  if (place) move(node, *place, {Support::Kind::Edge, link.edge});
  return place.has_value();
}

void CrowdedLinks::move(std::int32_t node, const Vec3& place, const Support& support) {
  nodes_.positions[node] = place;
  nodes_.supports[node] = support;
  nodes_.state[node] = NodeState::Free;
  changed_[node] = 1;
}

Vec3 CrowdedLinks::along(std::int32_t node) const {
  const Support& on = nodes_.supports[node];
  if (on.kind != Support::Kind::Edge) return {};
  const auto& chain = chains_[on.entity];
  const auto at = std::ranges::find(chain, node, &NodeOnEdge::node);
  if (at == chain.end()) return {};
  const auto before = at == chain.begin() ? at : std::prev(at);
  const auto after = std::next(at) == chain.end() ? at : std::next(at);
  const Vec3 from_to = nodes_.positions[after->node] - nodes_.positions[before->node];
  return from_to == Vec3{} ? from_to : normalised(from_to);
}

bool CrowdedLinks::set_opposite(const Link& link, std::int32_t node) {
  const Vec3 a = nodes_.positions[link.a], b = nodes_.positions[link.b];
  const Vec3 p = nodes_.positions[node];
  const Vec3 here = (b - a) / link.length;
  Vec3 there = along(node);
  if (dot(here, there) < 0) there = -there;
  const Vec3 across = here + there;  // a plane with this normal meets both edges at one angle
  const double at = dot(p - a, across) / dot(b - a, across);
  if (at >= kLeastPart && at <= 1 - kLeastPart) return split(link, at);
  if (there == Vec3{}) return false;
  const Support on = nodes_.supports[node];
  const Vec3& end = at < 0.5 ? a : b;
  const Vec3 place = project(boundary_, on, p + dot(end - p, across) / dot(there, across) * there);
  if (distance(place, p) > link.length) return false;
  bool taken = false;
  grid_.for_each_within(place, kLeastPart * link.length, [&](std::int32_t n, double) {
    const Support& other = nodes_.supports[n];
    taken |= n != node && (other == on || other.kind == Support::Kind::Vertex);
  });
  if (taken) return false;
  move(node, place, on);
  return true;
}

}  // namespace remeshd
