#include "engine/nodes/decimate_close_nodes.h"

#include "engine/nodes/nearest.h"

namespace remeshd {

namespace {

// x edge length: in regular meshes nodes are .65 from each other inside, and .35 on model edges.
constexpr double kCrowded = 0.46, kCrowdedOnEdge = 0.3;

}  // namespace

void decimate_close_nodes(CopiedNodes& nodes, const SizeField& sizes) {
  const NearestNode grid(nodes.positions, kGridCell * sizes.grid_length());
  std::vector<std::uint8_t> stays(nodes.positions.size());
  for (std::int32_t n = 0; n < nodes.size(); ++n)
    stays[n] = !nodes.is_free(n) || nodes.supports[n].kind == Support::Kind::Vertex;
  using Kind = Support::Kind;
  const auto too_close = [&](std::int32_t n, double edge_length, std::int32_t other,
                             double distance2) {
    const Support &s = nodes.supports[n], &o = nodes.supports[other];
    if (s.kind == o.kind && s.kind != Kind::Interior && s != o) return false;
    const bool on_edge = s.kind == Kind::Edge && o.kind == Kind::Edge;
    const double apart = (on_edge ? kCrowdedOnEdge : kCrowded) * edge_length;
    return distance2 < apart * apart;
  };
  const auto crowded = [&](std::int32_t n) {
    bool found = false;
    const double edge_length = sizes(nodes.positions[n]);
    grid.for_each_within(
        nodes.positions[n], kCrowded * edge_length, [&](std::int32_t other, double distance2) {
          found |= other != n && stays[other] && too_close(n, edge_length, other, distance2);
        });
    return found;
  };
  for (const Kind kind : {Kind::Edge, Kind::Face, Kind::Interior})
    for (std::int32_t n = 0; n < nodes.size(); ++n)
      if (!stays[n] && nodes.supports[n].kind == kind) stays[n] = !crowded(n);
  std::int32_t left = 0;
  for (std::int32_t n = 0; n < nodes.size(); ++n)
    if (stays[n]) nodes.move(n, left++);
  nodes.resize(left);
}

}  // namespace remeshd
