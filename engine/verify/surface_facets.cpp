#include "engine/verify/surface_facets.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/mesh/facet_ref.h"

namespace remeshd {
namespace {

/// A facet by its nodes, the smallest of which is known from the bucket.
struct Entry {
  std::int32_t mid, high;
  FacetRef facet;     ///< of the tet that was met first
  std::int32_t next;  ///< entry of the same bucket, -1 at the end
  std::int8_t turn;   ///< sign of the permutation that sorts the outward facet
  std::int8_t tets;   ///< tets met so far; 2: two or more
};

/// A tet that clashes with those met before at a facet with this smallest node.
struct Clash {
  std::int32_t low, tet;
};

/// Hash buckets for the facets with one smallest node: consecutive tets that are near each other
/// use buckets that are near in memory. A node of a usual mesh is the smallest of some ten facets.
constexpr std::int32_t kBuckets = 8;

/// One bit for each facet of a tet, by the corner opposite.
using FacetMask = std::uint8_t;
constexpr FacetMask kAll = 15;
/// By a mask of corners: the facets whose corners are all in it.
constexpr std::array<FacetMask, 16> kFacetsBetween{0, 0, 0, 0, 0, 0, 0, 8, 0, 0, 0, 4, 0, 2, 1, 15};

/// Counts the tets at each facet, adds the tets that clash to `clashes`, by the facet's smallest
/// node, and marks in `alone`, by tet, the facets in one tet only. each(f) calls f(tet, mask of its
/// facets) for the tets and facets that take part; `count`: at least the number of these tets.
template <class Each>
void match(const CowVector<Tet>& tets, std::size_t node_count, std::size_t count, const Each& each,
           std::vector<std::int32_t>& clashes, std::vector<FacetMask>& alone, Polling& poll) {
  std::vector<std::int32_t> head(kBuckets * node_count, -1);  // first entry of the bucket
  std::vector<Entry> entries;
  entries.reserve(2 * count + count / 4);  // each facet has two tets, but for the surface's
  std::vector<Clash> found;
  each([&](std::size_t t, FacetMask wanted) {
    poll();
    const Tet tet = tets[t];
    for (int i = 0; i < 4; ++i) {
      if ((wanted >> i & 1) == 0) continue;
      // Without branches: which node is the smallest cannot be predicted.
      const auto& f = kTetFacets[i];
      const std::int32_t a = tet[f[0]], b = tet[f[1]], c = tet[f[2]];
      const std::int32_t low = std::min(std::min(a, b), c);
      const std::int32_t high = std::max(std::max(a, b), c);
      const std::int32_t mid = a ^ b ^ c ^ low ^ high;
      const int odd = static_cast<int>(a > b) ^ static_cast<int>(a > c) ^ static_cast<int>(b > c);
      const auto turn = static_cast<std::int8_t>(1 - 2 * odd);
      std::int32_t& first = head[kBuckets * static_cast<std::size_t>(low) +
                                 static_cast<std::size_t>((mid ^ high) % kBuckets)];
      std::int32_t at = first;
      while (at >= 0 && (entries[at].mid != mid || entries[at].high != high)) at = entries[at].next;
      if (at < 0) {
        const FacetRef facet(static_cast<std::int32_t>(t), i);
        entries.push_back({mid, high, facet, first, turn, 1});
        first = static_cast<std::int32_t>(entries.size()) - 1;
        continue;
      }
      Entry& entry = entries[at];
      if (entry.tets == 2 || entry.turn == turn)
        found.push_back({low, static_cast<std::int32_t>(t)});
      entry.tets = 2;
    }
  });
  for (const Entry& entry : entries)
    if (entry.tets == 1)
      alone[entry.facet.tet()] |= static_cast<FacetMask>(1 << entry.facet.corner());
  std::ranges::stable_sort(found, {}, &Clash::low);
  for (const Clash& clash : found) clashes.push_back(clash.tet);
}

std::vector<SurfaceFacet> collect(const CowVector<Tet>& tets, std::span<const FacetMask> alone) {
  std::vector<SurfaceFacet> surface;
  for (std::size_t t = 0; t < tets.size(); ++t)
    for (int i = 0; i < 4 && alone[t] >> i != 0; ++i) {
      if ((alone[t] >> i & 1) == 0) continue;
      const Tet& tet = tets[t];
      const auto& f = kTetFacets[i];
      surface.push_back({{tet[f[0]], tet[f[1]], tet[f[2]]}, static_cast<std::int32_t>(t)});
    }
  return surface;
}

}  // namespace

FacetMatch match_facets(const CowVector<Tet>& tets, std::size_t node_count, Polling& poll) {
  FacetMatch result;
  std::vector<FacetMask> alone(tets.size(), 0);
  const auto each = [&](auto&& f) {
    for (std::size_t t = 0; t < tets.size(); ++t) f(t, kAll);
  };
  match(tets, node_count, tets.size(), each, result.clashes, alone, poll);
  result.surface = collect(tets, alone);
  return result;
}

FacetMatch match_facets(const CowVector<Tet>& tets, std::size_t node_count,
                        const VerifiedParent& parent, const TetCorrespondence& inherited,
                        Polling& poll) {
  // All nodes of a tet that came or went are touched. So a facet with an untouched node has the
  // tets that it had in the parent; the others are matched with each other.
  const std::vector<std::uint8_t>& touched = inherited.touched;
  const auto each = [&](auto&& f) {
    for (const std::int32_t t : inherited.near) {
      const Tet& tet = tets[t];
      const FacetMask mask = kFacetsBetween[touched[tet[0]] | touched[tet[1]] << 1 |
                                            touched[tet[2]] << 2 | touched[tet[3]] << 3];
      if (mask != 0) f(static_cast<std::size_t>(t), mask);
    }
  };
  FacetMatch result;
  std::vector<FacetMask> alone(tets.size(), 0);
  match(tets, node_count, inherited.near.size(), each, result.clashes, alone, poll);
  for (const SurfaceFacet& facet : parent.surface) {
    poll();
    const std::int32_t t = inherited.same_tet[facet.tet];
    if (t < 0) continue;
    bool rim = true;
    std::int32_t corner = 6;  // the one opposite: 0 + 1 + 2 + 3 less the facet's
    for (const std::int32_t o : facet.nodes) {
      const std::int32_t n = inherited.heir[o];
      rim = rim && touched[n] != 0;
      for (int i = 0; i < 4; ++i)
        if (tets[t][i] == n) corner -= i;
    }
    if (!rim) alone[t] |= static_cast<FacetMask>(1 << corner);
  }
  result.surface = collect(tets, alone);
  return result;
}

std::vector<std::int32_t> repeated_tets(const CowVector<Tet>& tets, std::size_t node_count,
                                        std::span<const std::int32_t> clashes) {
  // Each facet of a repeated tet is in some tet that clashes, so that all its nodes are nodes of
  // such tets.
  std::vector<std::int32_t> repeated;
  if (clashes.empty()) return repeated;
  std::vector<std::uint8_t> flagged(node_count, 0);
  for (const std::int32_t t : clashes)
    for (const std::int32_t n : tets[t]) flagged[n] = 1;
  std::vector<std::pair<Tet, std::int32_t>> suspects;
  for (std::size_t t = 0; t < tets.size(); ++t) {
    Tet key = tets[t];
    if (!std::all_of(key.begin(), key.end(), [&](std::int32_t n) { return flagged[n] != 0; }))
      continue;
    std::sort(key.begin(), key.end());
    suspects.emplace_back(key, static_cast<std::int32_t>(t));
  }
  std::sort(suspects.begin(), suspects.end());
  for (std::size_t i = 1; i < suspects.size(); ++i)
    if (suspects[i].first == suspects[i - 1].first) repeated.push_back(suspects[i].second);
  std::sort(repeated.begin(), repeated.end());
  return repeated;
}

}  // namespace remeshd
