#include "engine/boundary/surface_crossings.h"

#include <algorithm>

#include "engine/kernel/box_pairs.h"
#include "engine/kernel/predicates.h"

namespace remeshd {
namespace {

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
    if (!has_corner(t, p) && !has_corner(t, q) && cuts(nodes, p, q, t)) return true;
  }
  return false;
}

}  // namespace

std::vector<std::pair<std::int32_t, std::int32_t>> surface_crossings(const SurfaceMesh& mesh,
                                                                     const Run& run) {
  std::vector<Box> boxes;
  for (const FaceFacet& f : mesh.facets) boxes.push_back(box_of(mesh.nodes, f.nodes));
  std::vector<std::pair<std::int32_t, std::int32_t>> found;
  Polling poll(run);
  kernel::for_each_touching_pair(boxes, [&](std::int32_t a, std::int32_t b) {
    poll();
    const Triangle& s = mesh.facets[a].nodes;
    const Triangle& t = mesh.facets[b].nodes;
    if (std::ranges::count_if(s, [&](std::int32_t n) { return has_corner(t, n); }) >= 2) return;
    if (side_cuts(mesh.nodes, s, t) || side_cuts(mesh.nodes, t, s)) found.emplace_back(a, b);
  });
  std::ranges::sort(found);
  return found;
}

}  // namespace remeshd
