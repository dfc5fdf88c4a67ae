#include "engine/boundary/surface_crossings.h"

#include <algorithm>
#include <numeric>

#include "engine/kernel/predicates.h"

namespace remeshd {
namespace {

bool overlap(const Box& a, const Box& b) {
  return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y &&
         a.lo.z <= b.hi.z && b.lo.z <= a.hi.z;
}

bool has(const Triangle& t, std::int32_t n) { return t[0] == n || t[1] == n || t[2] == n; }

/// Whether the segment p-q meets the triangle, its rim included; no answer within its plane.
bool cuts(const std::vector<Vec3>& nodes, std::int32_t p, std::int32_t q, const Triangle& t) {
  const Vec3 &a = nodes[t[0]], &b = nodes[t[1]], &c = nodes[t[2]];
  const int above = kernel::orientation(a, b, c, nodes[p]);
  const int below = kernel::orientation(a, b, c, nodes[q]);
  if (above * below > 0 || (above == 0 && below == 0)) return false;
  const int u = kernel::orientation(nodes[p], nodes[q], a, b);
  const int v = kernel::orientation(nodes[p], nodes[q], b, c);
  const int w = kernel::orientation(nodes[p], nodes[q], c, a);
  return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

/// Whether a side of `s` without a common node cuts `t`.
bool side_cuts(const std::vector<Vec3>& nodes, const Triangle& s, const Triangle& t) {
  for (int i = 0; i < 3; ++i) {
    const std::int32_t p = s[i], q = s[(i + 1) % 3];
    if (!has(t, p) && !has(t, q) && cuts(nodes, p, q, t)) return true;
  }
  return false;
}

}  // namespace

std::vector<std::pair<std::int32_t, std::int32_t>> surface_crossings(const SurfaceMesh& mesh,
                                                                     const Run& run) {
  std::vector<Box> boxes(mesh.facets.size());
  for (std::size_t k = 0; k < boxes.size(); ++k)
    for (const std::int32_t n : mesh.facets[k].nodes) boxes[k].add(mesh.nodes[n]);
  std::vector<std::int32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::int32_t k) { return boxes[k].lo.x; });
  std::vector<std::pair<std::int32_t, std::int32_t>> found;
  Polling poll(run);
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      poll();
      if (boxes[order[j]].lo.x > boxes[order[i]].hi.x) break;
      if (!overlap(boxes[order[i]], boxes[order[j]])) continue;
      const Triangle& s = mesh.facets[order[i]].nodes;
      const Triangle& t = mesh.facets[order[j]].nodes;
      if (std::ranges::count_if(s, [&](std::int32_t n) { return has(t, n); }) >= 2) continue;
      if (side_cuts(mesh.nodes, s, t) || side_cuts(mesh.nodes, t, s))
        found.emplace_back(order[i], order[j]);
    }
  return found;
}

}  // namespace remeshd
