#include "engine/verify/surface_facets.h"

#include <algorithm>
#include <utility>

namespace remeshd {
namespace {

/// A facet by its two larger nodes; the smallest names the bucket.
struct Entry {
  std::int32_t mid, high;
  std::int32_t facet;  ///< 4 * tet + corner opposite
  std::int32_t next;   ///< entry of the same bucket with the same `mid`, -1 at the end
  std::int8_t turn;    ///< sign of the permutation that sorts the outward facet
  std::int8_t tets;    ///< met so far, 2 standing for more
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

FacetMatch match_facets(std::span<const Tet> tets, std::size_t node_count, Polling& poll) {
  std::vector<std::uint32_t> end(node_count + 1, 0);
  for (const Tet& tet : tets) {
    poll();
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
  for (std::size_t t = 0; t < tets.size(); ++t) {
    poll();
    for (int i = 0; i < 4; ++i) {
      const Sorted s = sorted(tets[t], i);
      entries[end[s.nodes[0]]++] = {s.nodes[1], s.nodes[2], static_cast<std::int32_t>(4 * t + i),
                                    -1,         s.turn,     1};
    }
  }

  FacetMatch match;
  std::vector<std::int32_t> alone;
  std::vector<std::int32_t> head(node_count, -1);  // first entry of this bucket by its `mid`
  std::uint32_t begin = 0;
  for (std::size_t n = 0; n < node_count; ++n) {
    poll();
    for (std::uint32_t b = begin; b < end[n]; ++b) {
      Entry& entry = entries[b];
      std::int32_t a = head[entry.mid];
      while (a >= 0 && entries[a].high != entry.high) a = entries[a].next;
      if (a < 0) {
        entry.next = std::exchange(head[entry.mid], static_cast<std::int32_t>(b));
        continue;
      }
      entry.tets = 0;
      if (entries[a].tets == 2 || entries[a].turn == entry.turn)
        match.clashes.push_back(entry.facet / 4);
      entries[a].tets = 2;
    }
    for (std::uint32_t b = begin; b < end[n]; ++b) {
      head[entries[b].mid] = -1;
      if (entries[b].tets == 1) alone.push_back(entries[b].facet);
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
