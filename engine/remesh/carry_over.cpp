#include "engine/remesh/carry_over.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "engine/mesh/quality.h"
#include "engine/remesh/tet_index.h"

namespace remeshd {

namespace {

/// A tet this bad next to carried ones is not for the clean-up to mend.
constexpr double kSpoilt = 0.02;

class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  std::int32_t find(std::int32_t a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  void join(std::int32_t a, std::int32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::int32_t> parent_;
};

/// What clean-up did to the original, as exchangeable pieces. Piece k holds Delaunay tets and the
/// cleaned-up tets that stand for them: one and the same tet where clean-up left it alone.
struct Pieces {
  std::vector<std::vector<std::int32_t>> delaunay;   ///< by piece: indices into Master::tets
  std::vector<std::vector<std::int32_t>> delivered;  ///< by piece: indices into the delivered tets
  std::vector<std::int32_t> of_delaunay;  ///< by Delaunay tet: its cluster, -1: unchanged
  std::vector<std::int32_t> same;         ///< by Delaunay tet: the same delivered tet, or -1
};

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

/// Tets that share a facet, on either side of the exchange, belong to one cluster.
void join_across_facets(std::span<const Tet> tets, std::size_t node_count, UnionFind& sets,
                        Polling& poll) {
  std::vector<std::uint32_t> end(node_count + 1, 0);
  for (const Tet& t : tets)
    for (int i = 0; i < 4; ++i) ++end[facet_key(t, i)[0] + 1];
  for (std::size_t n = 1; n <= node_count; ++n) end[n] += end[n - 1];
  std::vector<BucketFacet> facets(4 * tets.size());
  for (std::size_t k = 0; k < tets.size(); ++k)
    for (int i = 0; i < 4; ++i) {
      const auto key = facet_key(tets[k], i);
      facets[end[key[0]]++] = {key[1], key[2], static_cast<std::int32_t>(k)};
    }
  std::uint32_t begin = 0;
  for (std::size_t n = 0; n < node_count; ++n) {
    poll();
    for (std::uint32_t a = begin; a < end[n]; ++a)
      for (std::uint32_t b = a + 1; b < end[n]; ++b)
        if (facets[a].mid == facets[b].mid && facets[a].high == facets[b].high)
          sets.join(facets[a].owner, facets[b].owner);
    begin = end[n];
  }
}

Pieces find_pieces(const Master& original, const TetMeshView& delivered, Polling& poll) {
  Pieces pieces;
  const TetIndex index(delivered.tets, original.positions.size(), poll);
  pieces.same.resize(original.tets.size());
  pieces.of_delaunay.assign(original.tets.size(), -1);
  std::vector<std::uint8_t> stands(delivered.tets.size(), 0);
  std::vector<std::int32_t> changed;  // Delaunay tets, then delivered ones
  for (std::size_t k = 0; k < original.tets.size(); ++k) {
    poll();
    pieces.same[k] = index.find(original.tets[k]);
    if (pieces.same[k] >= 0)
      stands[pieces.same[k]] = 1;
    else
      changed.push_back(static_cast<std::int32_t>(k));
  }
  const std::size_t delaunay_count = changed.size();
  for (std::size_t k = 0; k < delivered.tets.size(); ++k)
    if (!stands[k]) changed.push_back(static_cast<std::int32_t>(k));

  std::vector<Tet> tets;
  tets.reserve(changed.size());
  for (std::size_t c = 0; c < changed.size(); ++c)
    tets.push_back(c < delaunay_count ? original.tets[changed[c]] : delivered.tets[changed[c]]);
  UnionFind sets(changed.size());
  join_across_facets(tets, original.positions.size(), sets, poll);
  std::vector<std::int32_t> number(changed.size(), -1);
  for (std::size_t c = 0; c < changed.size(); ++c) {
    const std::int32_t root = sets.find(static_cast<std::int32_t>(c));
    if (number[root] < 0) {
      number[root] = static_cast<std::int32_t>(pieces.delaunay.size());
      pieces.delaunay.emplace_back();
      pieces.delivered.emplace_back();
    }
    if (c < delaunay_count) {
      pieces.delaunay[number[root]].push_back(changed[c]);
      pieces.of_delaunay[changed[c]] = number[root];
    } else {
      pieces.delivered[number[root]].push_back(changed[c]);
    }
  }
  return pieces;
}

/// The new mesh seen through the original's pieces.
class Carrier {
 public:
  Carrier(const NodeSet& nodes, std::span<const Tet> tets, const Master& original,
          const TetMeshView& delivered, std::span<const Transform> transforms, const Run& run)
      : nodes_(nodes),
        tets_(tets),
        original_(original),
        delivered_(delivered),
        transforms_(transforms),
        poll_(run),
        pieces_(find_pieces(original, delivered, poll_)) {
    match();
  }

  CarriedMesh carry() {
    while (give_back_spoilt()) {
    }
    return assemble();
  }

 private:
  /// Transformation shared by four unmoved copies, -1 otherwise; fills in their originals.
  std::int32_t common_transform(const Tet& t, Tet& originals) const {
    for (int i = 0; i < 4; ++i) {
      if (!unmoved_[t[i]] || nodes_.transform[t[i]] != nodes_.transform[t[0]]) return -1;
      originals[i] = nodes_.original[t[i]];
    }
    return nodes_.transform[t[0]];
  }

  void match() {
    const std::int32_t count = nodes_.size();
    unmoved_.assign(count, 0);
    for (std::int32_t n = 0; n < count; ++n)
      if (nodes_.original[n] >= 0)
        unmoved_[n] = nodes_.positions[n] == transforms_[nodes_.transform[n]].apply(
                                                 original_.positions[nodes_.original[n]]);
    const TetIndex index(original_.tets, original_.positions.size(), poll_);
    image_.assign(tets_.size(), -1);
    std::vector<std::uint32_t> found(pieces_.delaunay.size(), 0);
    std::vector<std::int32_t> transform(pieces_.delaunay.size(), -1);
    std::vector<std::uint8_t> whole(pieces_.delaunay.size(), 1);
    for (std::size_t k = 0; k < tets_.size(); ++k) {
      poll_();
      Tet originals{};
      const std::int32_t t = common_transform(tets_[k], originals);
      if (t < 0) continue;
      image_[k] = index.find(originals);
      if (image_[k] < 0) continue;
      const std::int32_t piece = pieces_.of_delaunay[image_[k]];
      if (piece < 0) continue;
      if (transform[piece] < 0) transform[piece] = t;
      if (transform[piece] != t) whole[piece] = 0;
      ++found[piece];
    }
    // Where a piece is whole, its delivered tets speak of nodes that the new mesh has once each.
    piece_tets_.resize(pieces_.delaunay.size());
    carried_piece_.assign(pieces_.delaunay.size(), 0);
    std::vector<std::int32_t> copy(original_.positions.size(), -1);
    for (std::int32_t n = 0; n < count; ++n)
      if (unmoved_[n]) copy[nodes_.original[n]] = n;
    for (std::size_t p = 0; p < pieces_.delaunay.size(); ++p) {
      if (!whole[p] || found[p] == 0 || found[p] != pieces_.delaunay[p].size()) continue;
      // Delivered tets may have nodes that none of the piece's Delaunay tets has.
      const auto came_along = [&](std::int32_t n) {
        return copy[n] >= 0 && nodes_.transform[copy[n]] == transform[p];
      };
      const auto& delivered = pieces_.delivered[p];
      if (!std::ranges::all_of(delivered, [&](std::int32_t d) {
            return std::ranges::all_of(delivered_.tets[d], came_along);
          }))
        continue;
      carried_piece_[p] = 1;
      for (const std::int32_t d : delivered) {
        Tet t = delivered_.tets[d];
        for (std::int32_t& n : t) n = copy[n];
        piece_tets_[p].push_back(t);
      }
    }
    carried_.assign(tets_.size(), 0);
    for (std::size_t k = 0; k < tets_.size(); ++k)
      carried_[k] = image_[k] >= 0 && (pieces_.of_delaunay[image_[k]] < 0 ||
                                       carried_piece_[pieces_.of_delaunay[image_[k]]]);
  }

  [[nodiscard]] bool stands_for_itself(std::size_t k) const {
    return image_[k] < 0 || pieces_.of_delaunay[image_[k]] < 0;
  }

  /// Delivered position where a carried tet holds the node, else that of the Delaunay master.
  [[nodiscard]] std::vector<Vec3> positions() const {
    std::vector<Vec3> p = nodes_.positions;
    for (std::int32_t n = 0; n < nodes_.size(); ++n)
      if (held_[n])
        p[n] = transforms_[nodes_.transform[n]].apply(delivered_.nodes[nodes_.original[n]]);
    return p;
  }

  void hold_nodes() {
    held_.assign(nodes_.size(), 0);
    for (std::size_t k = 0; k < tets_.size(); ++k)
      if (carried_[k] && stands_for_itself(k))
        for (const std::int32_t n : tets_[k]) held_[n] = 1;
    for (std::size_t p = 0; p < piece_tets_.size(); ++p)
      if (carried_piece_[p])
        for (const Tet& t : piece_tets_[p])
          for (const std::int32_t n : t) held_[n] = 1;
  }

  /// Gives back what was carried at the nodes of tets that the delivered positions have spoilt.
  /// Returns whether anything was.
  bool give_back_spoilt() {
    hold_nodes();
    const std::vector<Vec3> p = positions();
    std::vector<std::uint8_t> release(nodes_.size(), 0);
    bool any = false;
    for (std::size_t k = 0; k < tets_.size(); ++k) {
      poll_();
      if (carried_[k]) continue;
      const Tet& t = tets_[k];
      if (!held_[t[0]] && !held_[t[1]] && !held_[t[2]] && !held_[t[3]]) continue;
      const double now = volume_length(p[t[0]], p[t[1]], p[t[2]], p[t[3]]);
      if (now >= kSpoilt) continue;
      const auto& m = nodes_.positions;
      if (volume_length(m[t[0]], m[t[1]], m[t[2]], m[t[3]]) <= now) continue;
      for (const std::int32_t n : t)
        if (held_[n] && p[n] != m[n]) release[n] = 1, any = true;
    }
    if (!any) return false;
    const auto touched = [&](const Tet& t) {
      return release[t[0]] || release[t[1]] || release[t[2]] || release[t[3]];
    };
    for (std::size_t q = 0; q < piece_tets_.size(); ++q)
      if (carried_piece_[q] && std::any_of(piece_tets_[q].begin(), piece_tets_[q].end(), touched))
        carried_piece_[q] = 0;
    for (std::size_t k = 0; k < tets_.size(); ++k) {
      if (!carried_[k]) continue;
      const std::int32_t piece = pieces_.of_delaunay[image_[k]];
      if (touched(tets_[k])) {
        carried_[k] = 0;
        if (piece >= 0) carried_piece_[piece] = 0;
      }
    }
    for (std::size_t k = 0; k < tets_.size(); ++k)
      if (carried_[k] && !stands_for_itself(k) && !carried_piece_[pieces_.of_delaunay[image_[k]]])
        carried_[k] = 0;
    return true;
  }

  CarriedMesh assemble() {
    CarriedMesh result;
    result.mesh.nodes = positions();
    for (std::size_t k = 0; k < tets_.size(); ++k) {
      if (carried_[k] && !stands_for_itself(k)) continue;  // its piece stands for it
      result.mesh.tets.push_back(tets_[k]);
      result.dirty.push_back(!carried_[k]);
    }
    for (std::size_t p = 0; p < piece_tets_.size(); ++p) {
      if (!carried_piece_[p]) continue;
      for (const Tet& t : piece_tets_[p]) {
        result.mesh.tets.push_back(t);
        result.dirty.push_back(0);
      }
    }
    return result;
  }

  const NodeSet& nodes_;
  std::span<const Tet> tets_;
  const Master& original_;
  const TetMeshView& delivered_;
  std::span<const Transform> transforms_;
  Polling poll_;
  const Pieces pieces_;
  std::vector<std::uint8_t> unmoved_;  ///< by node: still the exact copy of its original
  std::vector<std::uint8_t> held_;     ///< by node: a carried tet holds it
  std::vector<std::int32_t> image_;    ///< by tet: the same Delaunay tet of the original, or -1
  std::vector<std::uint8_t> carried_;  ///< by tet
  std::vector<std::uint8_t> carried_piece_;   ///< by piece
  std::vector<std::vector<Tet>> piece_tets_;  ///< by piece: cleaned-up tets over the new nodes
};

}  // namespace

CarriedMesh carry_over(const NodeSet& nodes, std::span<const Tet> tets, const Master& original,
                       const TetMeshView& delivered, std::span<const Transform> transforms,
                       const Run& run) {
  return Carrier(nodes, tets, original, delivered, transforms, run).carry();
}

}  // namespace remeshd
