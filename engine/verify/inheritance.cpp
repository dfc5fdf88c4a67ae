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

/// Not as arrays, whose comparison is a call.
bool equal(const Tet& a, const Tet& b) {
  return ((a[0] ^ b[0]) | (a[1] ^ b[1]) | (a[2] ^ b[2]) | (a[3] ^ b[3])) == 0;
}

template <class Array>
bool has(const Array& array, std::int32_t index) {
  return index >= 0 && static_cast<std::size_t>(index) < array.size();
}

}  // namespace

Inheritance inherit(const PagedMesh& mesh, const VerifiedParent& parent, Polling& poll) {
  Inheritance result;
  const Pages<Vec3>& then = parent.mesh.nodes;
  std::vector<std::int32_t> image(mesh.nodes.size(), -1);
  std::vector<std::uint8_t> unmoved(mesh.nodes.size(), 0);  // where the parent has it, to the bit
  std::vector<std::uint8_t> still(mesh.nodes.size(), 0);    // and under the same number
  result.name.assign(then.size(), -1);
  for (std::size_t n = 0; n < image.size(); ++n) {
    const std::int32_t o = parent.node[n];
    if (!has(then, o) || result.name[o] >= 0) continue;
    image[n] = o;
    result.name[o] = static_cast<std::int32_t>(n);
    unmoved[n] = mesh.nodes[n] == then[o] ? 1 : 0;
    still[n] = unmoved[n] != 0 && o == static_cast<std::int32_t>(n) ? 1 : 0;
  }
  const auto all = [](const std::vector<std::uint8_t>& flags, const Tet& t) {
    return (flags[t[0]] & flags[t[1]] & flags[t[2]] & flags[t[3]]) != 0;
  };
  result.heir.assign(parent.mesh.tets.size(), -1);
  result.touched.assign(mesh.nodes.size(), 0);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    poll();
    const Tet& tet = mesh.tets[t];
    const std::int32_t o = parent.tet[t];
    const bool known = has(parent.mesh.tets, o) && result.heir[o] < 0;
    const auto index = static_cast<std::int32_t>(t);
    if (known && equal(tet, parent.mesh.tets[o]) && all(still, tet)) {
      result.heir[o] = index;
      continue;
    }
    const bool same = known && same_turn(parent.mesh.tets[o], {image[tet[0]], image[tet[1]],
                                                               image[tet[2]], image[tet[3]]});
    if (same)
      result.heir[o] = index;
    else
      for (const std::int32_t n : tet) result.touched[n] = 1;
    if (same && all(unmoved, tet)) continue;
    result.changed.push_back(index);
    if (same) result.gone.push_back(o);
  }
  for (std::size_t o = 0; o < parent.mesh.tets.size(); ++o) {
    if (result.heir[o] >= 0) continue;
    result.gone.push_back(static_cast<std::int32_t>(o));
    for (const std::int32_t n : parent.mesh.tets[o])
      if (result.name[n] >= 0) result.touched[result.name[n]] = 1;
  }
  const auto any = [&](const Tet& t) {
    const auto& at = result.touched;
    return (at[t[0]] | at[t[1]] | at[t[2]] | at[t[3]]) != 0;
  };
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    poll();
    if (any(mesh.tets[t])) result.near.push_back(static_cast<std::int32_t>(t));
  }
  return result;
}

}  // namespace remeshd
