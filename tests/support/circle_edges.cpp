#include "tests/support/circle_edges.h"

#include <cmath>
#include <vector>

#include "engine/base/angle.h"

namespace remeshd::test {

double fewest_edges_on_circles(const Revision& revision, int whole) {
  const BoundaryModel& boundary = revision.cells.boundary;
  std::vector<int> nodes(boundary.edges.size(), 0);
  for (const Support& s : revision.supports())
    if (s.kind == Support::Kind::Edge) ++nodes[s.entity];
  double fewest = HUGE_VAL;
  for (std::size_t e = 0; e < nodes.size(); ++e) {
    const BoundaryEdge& edge = boundary.edges[e];
    if (edge.curve.kind != Curve::Kind::Circle) continue;
    const double turns = edge.length / (kTurn * edge.curve.radius);
    const int edges = nodes[e] + (edge.closed() ? 0 : 1);
    const double share = std::floor(whole * turns + 1e-9);
    if (share >= 1) fewest = std::fmin(fewest, edges >= share ? whole : edges / turns);
  }
  return fewest;
}

}  // namespace remeshd::test
