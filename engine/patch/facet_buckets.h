#pragma once

#include <array>
#include <cstdint>
#include <utility>

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

}  // namespace remeshd
