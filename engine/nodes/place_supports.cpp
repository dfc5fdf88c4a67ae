#include "engine/nodes/place_supports.h"

#include "engine/nodes/nearest.h"

namespace remeshd {

void place_supports(NodeSet& nodes, const BoundaryModel& boundary, const Samples& samples,
                    const SizeField& sizes, double tolerance, std::int32_t first, const Run& run) {
  std::vector<std::int32_t> to_place;
  for (std::int32_t n = first; n < nodes.size(); ++n) {
    if (nodes.is_free(n)) nodes.supports[n] = {};
    if (nodes.supports[n].kind != Support::Kind::Interior) to_place.push_back(n);
  }
  if (to_place.empty()) return;
  const std::vector<Vec3> positions = samples.positions();
  const NearestNode grid(positions, kGridCell * sizes.grid_length());
  Polling poll(run);
  for (const std::int32_t n : to_place) {
    poll();
    const Vec3& p = nodes.positions[n];
    // The strongest kind of entity the node stands on (a vertex before an edge before a face), but
    // no stronger than it stood on before; of several of a kind the one with the nearest sample.
    Support best;
    double best_d = HUGE_VAL;
    grid.for_each_within(p, kSupportReach * sizes(p), [&](std::int32_t index, double d) {
      const Support& s = samples.points[index].support;
      if (s.kind < best.kind || (s.kind == best.kind && d >= best_d) ||
          s.kind > nodes.supports[n].kind)
        return;
      if (s != best && distance(project(boundary, s, p), p) > tolerance) return;
      best = s;
      best_d = d;
    });
    nodes.supports[n] = best;
    if (best.kind == Support::Kind::Interior) nodes.state[n] = NodeState::Free;
  }
}

}  // namespace remeshd
