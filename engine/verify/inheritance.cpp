#include "engine/verify/inheritance.h"

#include <numeric>
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

/// Which nodes of the mesh and of the parent are counterparts.
struct Taken {
  std::vector<std::int32_t> by_node;  ///< by node of the mesh: the parent's, or -1
  std::vector<std::int32_t> heir;     ///< by node of the parent: the mesh's, or -1
};

Taken take_nodes(const std::vector<std::uint8_t>& unchanged, const CowVector<Vec3>& then,
                 const CowVector<std::int32_t>& claims) {
  Taken taken{std::vector<std::int32_t>(unchanged.size(), -1),
              std::vector<std::int32_t>(then.size(), -1)};
  const auto take = [&](std::size_t n, std::int32_t o) {
    taken.by_node[n] = o;
    taken.heir[o] = static_cast<std::int32_t>(n);
  };
  for (std::size_t n = 0; n < unchanged.size(); ++n)
    if (unchanged[n] != 0) take(n, static_cast<std::int32_t>(n));
  for (std::size_t n = 0; n < unchanged.size(); ++n)
    if (unchanged[n] == 0 && has(then, claims[n]) && taken.heir[claims[n]] < 0) take(n, claims[n]);
  return taken;
}

/// Finds the tets with a touched node. An unchanged page is searched only where the parent's box
/// round it has a touched node in it, since its nodes stand where the parent has them.
void find_near(const PagedMesh& mesh, const VerifiedParent& parent, TetCorrespondence& result,
               Polling& poll) {
  const std::vector<std::uint8_t>& touched = result.touched;
  std::vector<Vec3> places;
  if (std::ranges::any_of(result.unchanged.page, [](std::uint8_t same) { return same != 0; }))
    for (std::size_t n = 0; n < touched.size(); ++n)
      if (touched[n] != 0) places.push_back(mesh.nodes[n]);
  const PagesNear at_touched(parent.mesh.tets, parent.boxes, places);
  for (std::size_t k = 0; k < mesh.tets.pages(); ++k, poll()) {
    if (result.unchanged.page[k] != 0 && !at_touched.may_be(mesh.tets, k)) continue;
    auto t = static_cast<std::int32_t>(k * mesh.tets.kPage);
    for (const Tet& tet : mesh.tets.page(k)) {
      if ((touched[tet[0]] | touched[tet[1]] | touched[tet[2]] | touched[tet[3]]) != 0)
        result.near.push_back(t);
      ++t;
    }
  }
}

}  // namespace

CorrespondingTets::CorrespondingTets(const Unchanged& unchanged, std::size_t tets, std::size_t then)
    : then_(then) {
  constexpr std::size_t kPage = CowVector<Tet>::kPage;
  begin_.assign((then + kPage - 1) / kPage, -1);
  for (std::size_t k = 0; k < begin_.size(); ++k) {
    if (k < unchanged.page.size() && unchanged.page[k] != 0) continue;
    begin_[k] = static_cast<std::int32_t>(same_tet_.size());
    same_tet_.resize(same_tet_.size() + kPage);
    std::iota(same_tet_.end() - kPage, same_tet_.end(), static_cast<std::int32_t>(k * kPage));
  }
  for (const std::int32_t t : unchanged.changed_tets)
    if (static_cast<std::size_t>(t) < then) set(t, -1);
  for (std::size_t o = tets; o < then; ++o) set(static_cast<std::int32_t>(o), -1);
}

TetCorrespondence correspond(const PagedMesh& mesh, const VerifiedParent& parent, Polling& poll) {
  const CowVector<Tet>& then = parent.mesh.tets;
  Unchanged same = unchanged(mesh, parent.mesh, parent.boxes);
  auto [image, heir] = take_nodes(same.node, parent.mesh.nodes, parent.node);
  CorrespondingTets heirs(same, mesh.tets.size(), then.size());
  TetCorrespondence result{std::move(same),
                           std::move(heirs),
                           std::move(heir),
                           std::vector<std::uint8_t>(mesh.nodes.size(), 0),
                           {},
                           {},
                           {}};
  const auto unmoved = [&](std::int32_t n) {
    return result.unchanged.node[n] != 0 || mesh.nodes[n] == parent.mesh.nodes[image[n]];
  };
  for (const std::int32_t t : result.unchanged.changed_tets) {
    poll();
    const Tet& tet = mesh.tets[t];
    const std::int32_t o = parent.tet[t];
    const bool same_tet =
        has(then, o) && result.same_tet[o] < 0 &&
        same_turn(then[o], {image[tet[0]], image[tet[1]], image[tet[2]], image[tet[3]]});
    if (same_tet)
      result.same_tet.set(o, t);
    else
      for (const std::int32_t n : tet) result.touched[n] = 1;
    if (same_tet && std::ranges::all_of(tet, unmoved)) continue;
    result.changed.push_back(t);
    if (same_tet) result.gone.push_back(o);
  }
  result.same_tet.for_each_without([&](std::int32_t o) {
    result.gone.push_back(o);
    for (const std::int32_t n : then[o])
      if (result.heir[n] >= 0) result.touched[result.heir[n]] = 1;
  });
  find_near(mesh, parent, result, poll);
  return result;
}

}  // namespace remeshd
