#include "tests/support/tet_neighbours.h"

#include <algorithm>

#include "engine/mesh/facet_ref.h"

namespace remeshd::test {

std::vector<std::array<std::int32_t, 4>> tet_neighbours(std::span<const Tet> tets,
                                                        std::size_t node_count) {
  struct Facet {
    std::int32_t mid, high;  // the two larger nodes; the smallest names the bucket
    FacetRef facet;
  };
  std::vector<std::uint32_t> begin(node_count + 1, 0);
  const auto sorted = [](const Tet& t, int i) {
    std::array<std::int32_t, 3> f{t[kTetFacets[i][0]], t[kTetFacets[i][1]], t[kTetFacets[i][2]]};
    if (f[0] > f[1]) std::swap(f[0], f[1]);
    if (f[1] > f[2]) std::swap(f[1], f[2]);
    if (f[0] > f[1]) std::swap(f[0], f[1]);
    return f;
  };
  for (const Tet& t : tets)
    for (int i = 0; i < 4; ++i) ++begin[sorted(t, i)[0] + 1];
  for (std::size_t n = 1; n <= node_count; ++n) begin[n] += begin[n - 1];
  std::vector<Facet> facets(tets.size() * 4);
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t k = 0; k < tets.size(); ++k)
    for (int i = 0; i < 4; ++i) {
      const auto f = sorted(tets[k], i);
      facets[next[f[0]]++] = {f[1], f[2], {static_cast<std::int32_t>(k), i}};
    }
  std::vector<std::array<std::int32_t, 4>> neighbours(tets.size(), {-1, -1, -1, -1});
  for (std::size_t n = 0; n < node_count; ++n) {
    for (std::uint32_t a = begin[n]; a < begin[n + 1]; ++a) {
      if (facets[a].facet.is_none()) continue;
      for (std::uint32_t b = a + 1; b < begin[n + 1]; ++b) {
        if (facets[b].facet.is_none() || facets[a].mid != facets[b].mid ||
            facets[a].high != facets[b].high)
          continue;
        const FacetRef one = facets[a].facet, other = facets[b].facet;
        neighbours[one.tet()][one.corner()] = other.tet();
        neighbours[other.tet()][other.corner()] = one.tet();
        facets[b].facet = FacetRef::none();
        break;
      }
    }
  }
  return neighbours;
}

}  // namespace remeshd::test
