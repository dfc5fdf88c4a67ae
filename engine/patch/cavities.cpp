#include "engine/patch/cavities.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "engine/base/union_find.h"
#include "engine/mesh/grouping.h"
#include "engine/patch/facet_buckets.h"
#include "engine/patch/tet_index.h"

namespace remeshd {

namespace {

/// The changed tets at one facet, by mesh (Delaunay, output) and side: -1 where there is none.
using FacetOwners = std::array<std::array<std::int32_t, 2>, 2>;

/// Whether both meshes have a facet, with tets on the same sides of it.
bool in_both(const FacetOwners& owners) {
  const auto alike = [&](int side) { return (owners[0][side] < 0) == (owners[1][side] < 0); };
  return alike(0) && alike(1);
}

void join_at_facet(const FacetOwners& owners, CavityExtent extent, UnionFind& sets) {
  const bool by_side = extent == CavityExtent::Least && in_both(owners);
  std::array<std::int32_t, 2> first{-1, -1};  // by side; unless by_side, [0] for both
  for (int side = 0; side < 2; ++side)
    for (const auto& of_mesh : owners) {
      if (of_mesh[side] < 0) continue;
      std::int32_t& joined = first[by_side ? side : 0];
      if (joined < 0) joined = of_mesh[side];
      sets.join(joined, of_mesh[side]);
    }
}

/// Joins the changed tets that belong to one cavity. `delaunay_count`: the first so many are of the
/// Delaunay mesh, the others of the output.
void join_across_facets(std::span<const Tet> tets, std::size_t delaunay_count,
                        std::size_t node_count, CavityExtent extent, UnionFind& sets,
                        Polling& poll) {
  const auto facets = grouped<BucketFacet>(node_count, [&](const auto& visit) {
    for (std::size_t k = 0; k < tets.size(); ++k)
      for (int i = 0; i < 4; ++i) {
        const auto [low, facet] = facet_of(tets[k], i, static_cast<std::int32_t>(k));
        visit(low, facet);
      }
  });
  for (std::size_t n = 0; n < node_count; ++n) {
    poll();
    for_each_facet(facets[n], [&](const std::vector<BucketFacet>& same) {
      FacetOwners owners{{{-1, -1}, {-1, -1}}};
      for (const BucketFacet& facet : same) {
        const bool output = static_cast<std::size_t>(facet.owner) >= delaunay_count;
        std::int32_t& owner = owners[output ? 1 : 0][facet.even ? 1 : 0];
        if (owner >= 0) sets.join(owner, facet.owner);  // two on one side: the mesh is wrong there
        owner = facet.owner;
      }
      join_at_facet(owners, extent, sets);
    });
  }
}

/// The changed tets of both meshes, and which belong to one cavity.
class Exchange {
 public:
  Exchange(std::span<const Tet> delaunay, std::span<const Tet> output, std::size_t node_count,
           CavityExtent extent)
      : delaunay_(delaunay), output_(output), node_count_(node_count), extent_(extent) {}

  /// `same`: by Delaunay tet the same output tet, or -1.
  void join(std::span<const std::int32_t> same, Polling& poll) {
    changed_.clear();
    std::vector<std::uint8_t> stands(output_.size(), 0);
    for (std::size_t k = 0; k < delaunay_.size(); ++k)
      if (same[k] >= 0)
        stands[same[k]] = 1;
      else
        changed_.push_back(static_cast<std::int32_t>(k));
    delaunay_count_ = changed_.size();
    for (std::size_t k = 0; k < output_.size(); ++k)
      if (!stands[k]) changed_.push_back(static_cast<std::int32_t>(k));
    std::vector<Tet> tets;
    tets.reserve(changed_.size());
    for (std::size_t c = 0; c < changed_.size(); ++c) tets.push_back(tet(c));
    sets_ = UnionFind(changed_.size());
    join_across_facets(tets, delaunay_count_, node_count_, extent_, sets_, poll);
    for (const auto& [of_delaunay, of_output] : anchors_)
      sets_.join(place(of_delaunay, 0, delaunay_count_),
                 place(of_output, delaunay_count_, changed_.size()));
  }

  /// A last resort may have made output tets where no changed Delaunay tet is. A cavity without
  /// Delaunay tets could never be found again, so each such cavity is joined with the Delaunay tet
  /// that has most nodes of one of its tets, which then does not stand for itself any more. Returns
  /// whether there were any; if so, `join` has to be called again.
  bool anchor(std::span<std::int32_t> same) {
    std::vector<std::uint8_t> has(changed_.size(), 0);
    for (std::size_t c = 0; c < delaunay_count_; ++c) has[root(c)] = 1;
    std::vector<std::int32_t> alone;  // one output tet of each such cavity
    for (std::size_t c = delaunay_count_; c < changed_.size(); ++c)
      if (std::exchange(has[root(c)], 1) == 0) alone.push_back(changed_[c]);
    if (alone.empty() || delaunay_.empty()) return false;
    const auto at_node = grouped<std::int32_t>(node_count_, [&](const auto& visit) {
      for (std::size_t k = 0; k < delaunay_.size(); ++k)
        for (const std::int32_t n : delaunay_[k]) visit(n, static_cast<std::int32_t>(k));
    });
    for (const std::int32_t o : alone) {
      std::map<std::int32_t, int> common;
      for (const std::int32_t n : output_[o])
        for (const std::int32_t d : at_node[n]) ++common[d];
      const auto most =
          std::ranges::max_element(common, {}, [](const auto& c) { return c.second; });
      const std::int32_t d = most == common.end() ? 0 : most->first;
      anchors_.emplace_back(d, o);
      same[d] = -1;
    }
    return true;
  }

  void list(Cavities& cavities) {
    std::vector<std::int32_t> number(changed_.size(), -1);
    for (std::size_t c = 0; c < changed_.size(); ++c) {
      std::int32_t& at = number[root(c)];
      if (at < 0) {
        at = static_cast<std::int32_t>(cavities.list.size());
        cavities.list.emplace_back();
      }
      if (c < delaunay_count_) {
        cavities.list[at].delaunay.push_back(changed_[c]);
        cavities.of_tet[changed_[c]] = at;
      } else {
        cavities.list[at].output.push_back(changed_[c]);
      }
    }
  }

 private:
  [[nodiscard]] const Tet& tet(std::size_t c) const {
    return c < delaunay_count_ ? delaunay_[changed_[c]] : output_[changed_[c]];
  }
  [[nodiscard]] std::int32_t root(std::size_t c) {
    return sets_.find(static_cast<std::int32_t>(c));
  }
  /// Where a tet stands among the changed ones of its mesh, which are ascending.
  [[nodiscard]] std::int32_t place(std::int32_t of, std::size_t begin, std::size_t end) const {
    const auto first = changed_.begin();
    return static_cast<std::int32_t>(std::lower_bound(first + static_cast<std::ptrdiff_t>(begin),
                                                      first + static_cast<std::ptrdiff_t>(end),
                                                      of) -
                                     first);
  }

  std::span<const Tet> delaunay_, output_;
  std::size_t node_count_;
  CavityExtent extent_;
  std::vector<std::int32_t> changed_;  ///< Delaunay tets, then output ones
  std::size_t delaunay_count_ = 0;     ///< of those
  UnionFind sets_{0};
  std::vector<std::pair<std::int32_t, std::int32_t>> anchors_;  ///< a Delaunay tet, an output one
};

}  // namespace

Cavities find_cavities(std::span<const Tet> delaunay, std::span<const Tet> output,
                       std::span<const std::int32_t> same, std::size_t node_count,
                       CavityExtent extent, const Run& run) {
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
  const TetIndex index(output, stands, node_count, extent == CavityExtent::Least, poll);
  for (std::size_t k = 0; k < delaunay.size(); ++k) {
    poll();
    if (cavities.same[k] < 0) cavities.same[k] = index.find(delaunay[k]);
    if (cavities.same[k] >= 0) stands[cavities.same[k]] = 1;
  }
  Exchange exchange(delaunay, output, node_count, extent);
  do exchange.join(cavities.same, poll);
  while (exchange.anchor(cavities.same));
  exchange.list(cavities);
  return cavities;
}

}  // namespace remeshd
