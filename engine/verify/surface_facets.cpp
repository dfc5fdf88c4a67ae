#include "engine/verify/surface_facets.h"

#include <algorithm>
#include <utility>

namespace remeshd {
namespace {

/// A facet by its two larger nodes; the smallest names the bucket.
struct Entry {
  std::int32_t mid, high;
  std::int32_t facet;  ///< 4 * tet + corner opposite
  std::int8_t turn;    ///< sign of the permutation that sorts the outward facet; 0 once matched
};

struct Sorted {
  std::array<std::int32_t, 3> nodes;
  std::int8_t turn;
};

Sorted sorted(const Tet& tet, int corner) {
  const auto& f = kTetFacets[corner];
  Sorted s{{tet[f[0]], tet[f[1]], tet[f[2]]}, 1};
  const auto order = [&](int i, int j) {
    if (s.nodes[i] <= s.nodes[j]) return;
    std::swap(s.nodes[i], s.nodes[j]);
    s.turn = static_cast<std::int8_t>(-s.turn);
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return s;
}

}  // namespace

FacetMatch match_facets(std::span<const Tet> tets, std::size_t node_count) {
  std::vector<std::uint32_t> end(node_count + 1, 0);
  for (const Tet& tet : tets) {
    // Three of the four facets have the tet's smallest node as theirs, the fourth the second.
    std::int32_t first = tet[0];
    std::int32_t second = tet[1];
    if (first > second) std::swap(first, second);
    for (const std::int32_t n : {tet[2], tet[3]}) {
      if (n < first)
        second = std::exchange(first, n);
      else if (n < second)
        second = n;
    }
    end[first + 1] += 3;
    end[second + 1] += 1;
  }
  for (std::size_t n = 1; n <= node_count; ++n) end[n] += end[n - 1];
  std::vector<Entry> entries(4 * tets.size());
  for (std::size_t t = 0; t < tets.size(); ++t)
    for (int i = 0; i < 4; ++i) {
      const Sorted s = sorted(tets[t], i);
      entries[end[s.nodes[0]]++] = {s.nodes[1], s.nodes[2], static_cast<std::int32_t>(4 * t + i),
                                    s.turn};
    }

  FacetMatch match;
  std::vector<std::int32_t> alone;
  std::uint32_t begin = 0;
  for (std::size_t n = 0; n < node_count; ++n) {
    for (std::uint32_t a = begin; a < end[n]; ++a) {
      if (entries[a].turn == 0) continue;
      int partners = 0;
      for (std::uint32_t b = a + 1; b < end[n]; ++b) {
        if (entries[b].turn == 0 || entries[b].mid != entries[a].mid ||
            entries[b].high != entries[a].high)
          continue;
        if (++partners > 1 || entries[b].turn == entries[a].turn)
          match.clashes.push_back(entries[b].facet / 4);
        entries[b].turn = 0;
      }
      if (partners == 0) alone.push_back(entries[a].facet);
    }
    begin = end[n];
  }
  std::sort(alone.begin(), alone.end());
  match.surface.reserve(alone.size());
  for (const std::int32_t facet : alone) {
    const Tet& tet = tets[facet / 4];
    const auto& f = kTetFacets[facet % 4];
    match.surface.push_back({{tet[f[0]], tet[f[1]], tet[f[2]]}, facet / 4});
  }
  return match;
}

}  // namespace remeshd
