#include "engine/verify/inheritance.h"

#include <utility>

namespace remeshd {
namespace {

/// Whether b has the nodes of a in an even permutation of their order.
bool same_turn(const Tet& a, Tet b) {
  bool even = true;
  for (int i = 0; i < 3; ++i) {
    int j = i;
    while (j < 4 && b[j] != a[i]) ++j;
    if (j == 4) return false;
    if (j == i) continue;
    std::swap(b[i], b[j]);
    even = !even;
  }
  return even && a[3] == b[3];
}

template <class Array>
bool has(const Array& array, std::int32_t index) {
  return index >= 0 && static_cast<std::size_t>(index) < array.size();
}

}  // namespace

Inheritance inherit(const TetMesh& mesh, const VerifiedParent& parent, Polling& poll) {
  Inheritance result;
  const std::span<const Vec3> then = parent.mesh.nodes;
  std::vector<std::int32_t> image(mesh.nodes.size(), -1);
  result.name.assign(then.size(), -1);
  result.unmoved.assign(mesh.nodes.size(), 0);
  for (std::size_t n = 0; n < image.size(); ++n) {
    const std::int32_t o = parent.node[n];
    if (!has(then, o) || result.name[o] >= 0) continue;
    image[n] = o;
    result.name[o] = static_cast<std::int32_t>(n);
    result.unmoved[n] = mesh.nodes[n] == then[o] ? 1 : 0;
  }
  result.same.assign(mesh.tets.size(), -1);
  result.heir.assign(parent.mesh.tets.size(), -1);
  result.touched.assign(mesh.nodes.size(), 0);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    poll();
    const Tet& tet = mesh.tets[t];
    const std::int32_t o = parent.tet[t];
    if (has(parent.mesh.tets, o) && result.heir[o] < 0 &&
        same_turn(parent.mesh.tets[o],
                  {image[tet[0]], image[tet[1]], image[tet[2]], image[tet[3]]})) {
      result.same[t] = o;
      result.heir[o] = static_cast<std::int32_t>(t);
    } else {
      for (const std::int32_t n : tet) result.touched[n] = 1;
    }
  }
  for (std::size_t o = 0; o < parent.mesh.tets.size(); ++o) {
    if (result.heir[o] >= 0) continue;
    for (const std::int32_t n : parent.mesh.tets[o])
      if (result.name[n] >= 0) result.touched[result.name[n]] = 1;
  }
  return result;
}

}  // namespace remeshd
