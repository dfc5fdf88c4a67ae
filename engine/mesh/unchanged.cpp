#include "engine/mesh/unchanged.h"

#include <algorithm>
#include <span>

namespace remeshd {
namespace {

/// Written out, because the `==` of a std::array is a library call.
bool equal(const Tet& a, const Tet& b) {
  return ((a[0] ^ b[0]) | (a[1] ^ b[1]) | (a[2] ^ b[2]) | (a[3] ^ b[3])) == 0;
}

std::vector<std::uint8_t> unchanged_nodes(const CowVector<Vec3>& nodes,
                                          const CowVector<Vec3>& other) {
  std::vector<std::uint8_t> same(nodes.size(), 0);
  for (std::size_t k = 0; k < std::min(nodes.pages(), other.pages()); ++k) {
    const std::span<const Vec3> now = nodes.page(k), then = other.page(k);
    const std::size_t count = std::min(now.size(), then.size());
    std::uint8_t* out = same.data() + k * nodes.kPage;
    if (nodes.shares(k, other))
      std::fill_n(out, count, std::uint8_t{1});
    else
      for (std::size_t i = 0; i < count; ++i) out[i] = now[i] == then[i] ? 1 : 0;
  }
  return same;
}

/// Where the other mesh has the nodes that this one has elsewhere or not at all.
std::vector<Vec3> left_places(const std::vector<std::uint8_t>& same, const CowVector<Vec3>& other) {
  std::vector<Vec3> places;
  for (std::size_t n = 0; n < other.size(); ++n)
    if (n >= same.size() || same[n] == 0) places.push_back(other[n]);
  return places;
}

}  // namespace

Unchanged unchanged(const PagedMesh& mesh, const PagedMesh& other, const CowVector<Box>& boxes) {
  Unchanged result{unchanged_nodes(mesh.nodes, other.nodes), {}, {}};
  const std::vector<std::uint8_t>& node = result.node;
  const PagesNear at_left(other.tets, boxes, left_places(node, other.nodes));
  const auto stands = [&](const Tet& t) {
    return (node[t[0]] & node[t[1]] & node[t[2]] & node[t[3]]) != 0;
  };
  result.page.assign(mesh.tets.pages(), 0);
  for (std::size_t k = 0; k < mesh.tets.pages(); ++k) {
    const std::span<const Tet> now = mesh.tets.page(k);
    const std::span<const Tet> then =
        k < other.tets.pages() ? other.tets.page(k) : std::span<const Tet>();
    const std::size_t changed_before = result.changed_tets.size();
    if (now.size() != then.size() || at_left.may_be(mesh.tets, k))
      for (std::size_t i = 0; i < now.size(); ++i)
        if (i >= then.size() || !equal(now[i], then[i]) || !stands(now[i]))
          result.changed_tets.push_back(static_cast<std::int32_t>(k * mesh.tets.kPage + i));
    if (result.changed_tets.size() == changed_before && now.size() == then.size())
      result.page[k] = 1;
  }
  return result;
}

}  // namespace remeshd
