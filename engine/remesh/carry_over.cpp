#include "engine/remesh/carry_over.h"

#include <algorithm>

#include "engine/mesh/quality.h"
#include "engine/optimise/live_mesh.h"
#include "engine/remesh/tet_index.h"

namespace remeshd {

namespace {

/// A tet this bad next to carried ones is not for the clean-up to mend.
constexpr double kSpoilt = 0.02;

/// The new mesh seen through the original's pieces.
class Carrier {
 public:
  Carrier(const NodeSet& nodes, const PeeledMesh& peeled, const OriginalPart& original,
          std::span<const Transform> transforms, const Run& run)
      : nodes_(nodes),
        tets_(peeled.tets),
        slots_(peeled.slots),
        original_(original),
        transforms_(transforms),
        poll_(run),
        pieces_(original.pieces) {
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

  void find_images() {
    std::vector<std::int32_t> at_slot(original_.inside.size(), -1);  // the original's peeled tet
    std::int32_t next = 0;
    for (std::size_t s = 0; s < at_slot.size(); ++s)
      if (original_.inside[s] != 0) at_slot[s] = next++;
    std::vector<std::uint8_t> taken(original_.tets.size(), 0);
    std::vector<std::int32_t> others;  // that do not stand where they stood
    image_.assign(tets_.size(), -1);
    Tet originals{};
    for (std::size_t k = 0; k < tets_.size(); ++k) {
      poll_();
      if (common_transform(tets_[k], originals) < 0) continue;
      const auto slot = static_cast<std::size_t>(slots_[k]);
      const std::int32_t o = slot < at_slot.size() ? at_slot[slot] : -1;
      if (o >= 0 && original_.tets[o] == originals) {
        image_[k] = o;
        taken[o] = 1;
      } else {
        others.push_back(static_cast<std::int32_t>(k));
      }
    }
    const TetIndex index(original_.tets, taken, original_.positions.size(), poll_);
    for (const std::int32_t k : others) {
      common_transform(tets_[k], originals);
      image_[k] = index.find(originals);
    }
  }

  void match() {
    const std::int32_t count = nodes_.size();
    unmoved_.assign(count, 0);
    for (std::int32_t n = 0; n < count; ++n)
      if (nodes_.original[n] >= 0)
        unmoved_[n] = nodes_.positions[n] == transforms_[nodes_.transform[n]].apply(
                                                 original_.positions[nodes_.original[n]]);
    find_images();
    std::vector<std::uint32_t> found(pieces_.clusters.size(), 0);
    std::vector<std::int32_t> transform(pieces_.clusters.size(), -1);
    std::vector<std::uint8_t> whole(pieces_.clusters.size(), 1);
    for (std::size_t k = 0; k < tets_.size(); ++k) {
      if (image_[k] < 0) continue;
      const std::int32_t t = nodes_.transform[tets_[k][0]];
      const std::int32_t piece = pieces_.cluster[image_[k]];
      if (piece < 0) continue;
      if (transform[piece] < 0) transform[piece] = t;
      if (transform[piece] != t) whole[piece] = 0;
      ++found[piece];
    }
    // Where a piece is whole, its delivered tets speak of nodes that the new mesh has once each.
    piece_tets_.resize(pieces_.clusters.size());
    carried_piece_.assign(pieces_.clusters.size(), 0);
    std::vector<std::int32_t> copy(original_.positions.size(), -1);
    for (std::int32_t n = 0; n < count; ++n)
      if (unmoved_[n]) copy[nodes_.original[n]] = n;
    for (std::size_t p = 0; p < pieces_.clusters.size(); ++p) {
      if (!whole[p] || found[p] == 0 || found[p] != pieces_.clusters[p].delaunay.size()) continue;
      // Delivered tets may have nodes that none of the piece's Delaunay tets has.
      const auto came_along = [&](std::int32_t n) {
        return copy[n] >= 0 && nodes_.transform[copy[n]] == transform[p];
      };
      const auto& delivered = pieces_.clusters[p].delivered;
      if (!std::ranges::all_of(delivered, [&](std::int32_t d) {
            return std::ranges::all_of(original_.delivered[d], came_along);
          }))
        continue;
      carried_piece_[p] = 1;
      for (const std::int32_t d : delivered) {
        Tet t = original_.delivered[d];
        for (std::int32_t& n : t) n = copy[n];
        piece_tets_[p].push_back(t);
      }
    }
    carried_.assign(tets_.size(), 0);
    for (std::size_t k = 0; k < tets_.size(); ++k)
      carried_[k] = image_[k] >= 0 &&
                    (pieces_.cluster[image_[k]] < 0 || carried_piece_[pieces_.cluster[image_[k]]]);
  }

  [[nodiscard]] bool stands_for_itself(std::size_t k) const {
    return image_[k] < 0 || pieces_.cluster[image_[k]] < 0;
  }

  /// Delivered position where a carried tet holds the node, else that of the Delaunay master.
  [[nodiscard]] std::vector<Vec3> positions() const {
    std::vector<Vec3> p = nodes_.positions;
    for (std::int32_t n = 0; n < nodes_.size(); ++n)
      if (held_[n])
        p[n] =
            transforms_[nodes_.transform[n]].apply(original_.delivered_nodes[nodes_.original[n]]);
    return p;
  }

  void hold_nodes() {
    held_.assign(nodes_.size(), 0);
    std::fill_n(held_.begin(), nodes_.rim, 1);
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
      const auto spoils = [&](std::int32_t n) { return held_[n] && p[n] != m[n]; };
      bool released = false;
      for (const std::int32_t n : t)
        if (n >= nodes_.rim && spoils(n)) release[n] = 1, released = true;
      if (!released && std::ranges::any_of(t, spoils)) throw LeftPart{"carrying tets over"};
      any |= released;
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
      const std::int32_t piece = pieces_.cluster[image_[k]];
      if (touched(tets_[k])) {
        carried_[k] = 0;
        if (piece >= 0) carried_piece_[piece] = 0;
      }
    }
    for (std::size_t k = 0; k < tets_.size(); ++k)
      if (carried_[k] && !stands_for_itself(k) && !carried_piece_[pieces_.cluster[image_[k]]])
        carried_[k] = 0;
    return true;
  }

  CarriedMesh assemble() {
    CarriedMesh result;
    result.mesh.nodes = positions();
    const auto add = [&](const Tet& tet, bool dirty, std::int32_t peeled, std::int32_t delivered) {
      result.mesh.tets.push_back(tet);
      result.dirty.push_back(dirty ? 1 : 0);
      result.same.peeled.push_back(peeled);
      result.same.delivered.push_back(delivered);
    };
    for (std::size_t k = 0; k < tets_.size(); ++k) {
      if (carried_[k] && !stands_for_itself(k)) continue;  // its piece stands for it
      add(tets_[k], !carried_[k], static_cast<std::int32_t>(k),
          image_[k] < 0 ? -1 : pieces_.same[image_[k]]);
    }
    for (std::size_t p = 0; p < piece_tets_.size(); ++p) {
      if (!carried_piece_[p]) continue;
      for (std::size_t i = 0; i < piece_tets_[p].size(); ++i)
        add(piece_tets_[p][i], false, -1, pieces_.clusters[p].delivered[i]);
    }
    return result;
  }

  const NodeSet& nodes_;
  std::span<const Tet> tets_;
  std::span<const std::int32_t> slots_;  ///< by tet
  const OriginalPart& original_;
  std::span<const Transform> transforms_;
  Polling poll_;
  const Pieces& pieces_;
  std::vector<std::uint8_t> unmoved_;  ///< by node: still the exact copy of its original
  std::vector<std::uint8_t> held_;     ///< by node: a carried tet holds it
  std::vector<std::int32_t> image_;    ///< by tet: the same Delaunay tet of the original, or -1
  std::vector<std::uint8_t> carried_;  ///< by tet
  std::vector<std::uint8_t> carried_piece_;   ///< by piece
  std::vector<std::vector<Tet>> piece_tets_;  ///< by piece: cleaned-up tets over the new nodes
};

}  // namespace

CarriedMesh carry_over(const NodeSet& nodes, const PeeledMesh& peeled, const OriginalPart& original,
                       std::span<const Transform> transforms, const Run& run) {
  return Carrier(nodes, peeled, original, transforms, run).carry();
}

}  // namespace remeshd
