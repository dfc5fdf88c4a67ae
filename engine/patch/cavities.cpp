#include "engine/patch/cavities.h"

#include <algorithm>
#include <array>

#include "engine/base/union_find.h"
#include "engine/mesh/grouping.h"
#include "engine/patch/tet_index.h"

namespace remeshd {

namespace {

/// A facet by its two larger nodes; the smallest names the bucket that it stands in.
struct BucketFacet {
  std::int32_t mid, high;
  std::int32_t owner;
};

/// The nodes of the facet opposite a corner, ascending.
std::array<std::int32_t, 3> facet_key(const Tet& t, int corner) {
  const auto& f = kTetFacets[corner];
  std::array<std::int32_t, 3> key{t[f[0]], t[f[1]], t[f[2]]};
  std::sort(key.begin(), key.end());
  return key;
}

/// Tets that share a facet, on either side of the exchange, belong to one cavity.
void join_across_facets(std::span<const Tet> tets, std::size_t node_count, UnionFind& sets,
                        Polling& poll) {
  const auto facets = grouped<BucketFacet>(node_count, [&](const auto& visit) {
    for (std::size_t k = 0; k < tets.size(); ++k)
      for (int i = 0; i < 4; ++i) {
        const auto key = facet_key(tets[k], i);
        visit(key[0], BucketFacet{key[1], key[2], static_cast<std::int32_t>(k)});
      }
  });
  for (std::size_t n = 0; n < node_count; ++n) {
    poll();
    const std::span<const BucketFacet> at = facets[n];
    for (std::size_t a = 0; a < at.size(); ++a)
      for (std::size_t b = a + 1; b < at.size(); ++b)
        if (at[a].mid == at[b].mid && at[a].high == at[b].high) sets.join(at[a].owner, at[b].owner);
  }
}

}  // namespace

Cavities find_cavities(std::span<const Tet> delaunay, std::span<const Tet> output,
                       std::span<const std::int32_t> same, std::size_t node_count, const Run& run) {
  Polling poll(run);
  Cavities cavities;
  cavities.same.assign(delaunay.size(), -1);
  cavities.of_tet.assign(delaunay.size(), -1);
  std::vector<std::uint8_t> stands(output.size(), 0);
  for (std::size_t k = 0; k < same.size(); ++k) {
    if (same[k] < 0) continue;
    cavities.same[same[k]] = static_cast<std::int32_t>(k);
    stands[k] = 1;
  }
  const TetIndex index(output, stands, node_count, poll);
  std::vector<std::int32_t> changed;  // Delaunay tets, then output ones
  for (std::size_t k = 0; k < delaunay.size(); ++k) {
    poll();
    if (cavities.same[k] < 0) cavities.same[k] = index.find(delaunay[k]);
    if (cavities.same[k] >= 0)
      stands[cavities.same[k]] = 1;
    else
      changed.push_back(static_cast<std::int32_t>(k));
  }
  const std::size_t delaunay_count = changed.size();
  for (std::size_t k = 0; k < output.size(); ++k)
    if (!stands[k]) changed.push_back(static_cast<std::int32_t>(k));

  std::vector<Tet> tets;
  tets.reserve(changed.size());
  for (std::size_t c = 0; c < changed.size(); ++c)
    tets.push_back(c < delaunay_count ? delaunay[changed[c]] : output[changed[c]]);
  UnionFind sets(changed.size());
  join_across_facets(tets, node_count, sets, poll);
  std::vector<std::int32_t> number(changed.size(), -1);
  for (std::size_t c = 0; c < changed.size(); ++c) {
    const std::int32_t root = sets.find(static_cast<std::int32_t>(c));
    if (number[root] < 0) {
      number[root] = static_cast<std::int32_t>(cavities.list.size());
      cavities.list.emplace_back();
    }
    if (c < delaunay_count) {
      cavities.list[number[root]].delaunay.push_back(changed[c]);
      cavities.of_tet[changed[c]] = number[root];
    } else {
      cavities.list[number[root]].output.push_back(changed[c]);
    }
  }
  return cavities;
}

}  // namespace remeshd
