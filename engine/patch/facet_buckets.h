#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/mesh/tet_mesh.h"

namespace remeshd {

/// A facet of a tet by its two larger nodes; the smallest names the bucket it stands in.
struct BucketFacet {
  std::int32_t mid, high;
  std::int32_t owner;  ///< number of the tet
  bool even;           ///< which side of the facet the tet is on
};

/// The facet of a tet opposite a corner, and its smallest node.
inline std::pair<std::int32_t, BucketFacet> facet_of(const Tet& t, int corner, std::int32_t owner) {
  const auto& f = kTetFacets[corner];
  std::array<std::int32_t, 3> key{t[f[0]], t[f[1]], t[f[2]]};
  bool even = true;
  const auto order = [&](int i, int j) {
    if (key[i] < key[j]) return;
    std::swap(key[i], key[j]);
    even = !even;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return {key[0], {key[1], key[2], owner, even}};
}

/// Calls visit(same) for each facet of a bucket, with all that stand in it for that facet.
template <class Visit>
void for_each_facet(std::span<const BucketFacet> bucket, const Visit& visit) {
  std::vector<std::uint8_t> done(bucket.size(), 0);
  std::vector<BucketFacet> same;
  for (std::size_t a = 0; a < bucket.size(); ++a) {
    if (done[a] != 0) continue;
    same.clear();
    for (std::size_t b = a; b < bucket.size(); ++b) {
      if (bucket[a].mid != bucket[b].mid || bucket[a].high != bucket[b].high) continue;
      done[b] = 1;
      same.push_back(bucket[b]);
    }
    visit(std::as_const(same));
  }
}

}  // namespace remeshd
