#include "engine/patch/same_hull.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/patch/facet_buckets.h"

namespace remeshd {

namespace {

// In place of a tet's number: there is none, both meshes have it, it may not be exchanged.
constexpr std::int32_t kNone = -1, kBoth = -2, kFirstStays = -3, kSecondStays = -4;

/// The tets at one facet, by mesh and side.
using FacetOwners = std::array<std::array<std::int32_t, 2>, 2>;

/// Facets of the tets that may be exchanged, numbered those of the first mesh first, and of others
/// those that these may have too.
Grouping<BucketFacet> facets_of(const TwoMeshes& meshes, std::size_t node_count) {
  std::vector<std::uint8_t> at_some(node_count, 0);
  for (const std::span<const Tet> tets : {meshes.first, meshes.second})
    for (const Tet& t : tets)
      for (const std::int32_t n : t) at_some[n] = 1;
  const auto is_looked_at = [&](std::int32_t n) { return n >= 0 && at_some[n] != 0; };
  return grouped<BucketFacet>(node_count, [&](const auto& visit) {
    const auto visit_facets = [&](const Tet& t, std::int32_t owner) {
      if (std::ranges::count_if(t, is_looked_at) < 3) return;
      for (int i = 0; i < 4; ++i) {
        const auto [low, facet] = facet_of(t, i, owner);
        if (is_looked_at(low) && is_looked_at(facet.mid) && is_looked_at(facet.high))
          visit(low, facet);
      }
    };
    std::int32_t number = 0;
    for (const Tet& t : meshes.first) visit_facets(t, number++);
    for (const Tet& t : meshes.second) visit_facets(t, number++);
    for (const Tet& t : meshes.both) visit_facets(t, kBoth);
    for (const Tet& t : meshes.first_stay) visit_facets(t, kFirstStays);
    for (const Tet& t : meshes.second_stay) visit_facets(t, kSecondStays);
  });
}

FacetOwners owners_of(const std::vector<BucketFacet>& same, std::size_t first_count) {
  FacetOwners owners{{{kNone, kNone}, {kNone, kNone}}};
  for (const auto& [mid, high, owner, even] : same) {
    const int side = even ? 1 : 0;
    const bool of_first =
        owner == kFirstStays || (owner >= 0 && static_cast<std::size_t>(owner) < first_count);
    if (owner == kBoth)
      owners[0][side] = owners[1][side] = kBoth;
    else
      owners[of_first ? 0 : 1][side] = owner;
  }
  return owners;
}

}  // namespace

SameHull::SameHull(const TwoMeshes& meshes, std::size_t node_count, const Run& run)
    : first_count_(meshes.first.size()), in_(meshes.first.size() + meshes.second.size(), 1) {
  Polling poll(run);
  const auto facets = facets_of(meshes, node_count);
  std::vector<std::pair<std::int32_t, std::int32_t>> needs;  // a tet, one that needs it
  std::vector<std::int32_t> out;
  for (std::size_t n = 0; n < node_count; ++n) {
    poll();
    for_each_facet(facets[n], [&](const std::vector<BucketFacet>& same) {
      const FacetOwners owners = owners_of(same, first_count_);
      for (int mesh = 0; mesh < 2; ++mesh)
        for (int side = 0; side < 2; ++side) {
          const std::int32_t tet = owners[mesh][side], across = owners[mesh][1 - side];
          const std::int32_t same_side = owners[1 - mesh][side];
          const std::int32_t other_side = owners[1 - mesh][1 - side];
          if (tet < 0) continue;
          if (same_side >= 0)
            needs.emplace_back(same_side, tet);
          else if (same_side == kNone && other_side == kNone && across >= 0)
            needs.emplace_back(across, tet);
          else if (same_side != kNone || other_side != kNone || across != kNone)
            out.push_back(tet);
        }
    });
  }
  needed_by_ = grouped<std::int32_t>(in_.size(), [&](const auto& visit) {
    for (const auto& [needed, by] : needs) visit(needed, by);
  });
  for (const std::int32_t tet : out) leave_out(tet);
}

void SameHull::leave_out(std::int32_t tet) {
  if (std::exchange(in_[tet], 0) == 0) return;
  std::vector<std::int32_t> left{tet};
  while (!left.empty()) {
    const std::int32_t t = left.back();
    left.pop_back();
    for (const std::int32_t by : needed_by_[t])
      if (std::exchange(in_[by], 0) != 0) left.push_back(by);
  }
}

}  // namespace remeshd
