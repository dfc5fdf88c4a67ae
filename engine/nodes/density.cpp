#include "engine/nodes/density.h"

#include <cmath>

namespace remeshd {

double expected_nodes(double volume, double area, double edge_length) {
  const double l = edge_length;
  return std::sqrt(2.0) * volume / (l * l * l) + area / (std::sqrt(3.0) * l * l);
}

double nodes_needed(const Extent& extent, double edge_length) {
  return std::fmax(expected_nodes(extent.volume, extent.area, edge_length),
                   extent.length / edge_length);
}

double edge_length_for(double volume, double area, double nodes) {
  double lo = 0, hi = std::cbrt(volume) + std::sqrt(area);
  while (expected_nodes(volume, area, hi) > nodes) hi *= 2;
  for (int k = 0; k < 200 && hi - lo > 1e-13 * hi; ++k) {
    const double mid = 0.5 * (lo + hi);
    (expected_nodes(volume, area, mid) > nodes ? lo : hi) = mid;
  }
  return 0.5 * (lo + hi);
}

}  // namespace remeshd
