#include "engine/patch/reuse_improved_tets.h"

#include <algorithm>
#include <numeric>

#include "engine/mesh/quality.h"
#include "engine/optimise/live_mesh.h"
#include "engine/patch/same_hull.h"
#include "engine/patch/tet_index.h"

namespace remeshd {

namespace {

/// A tet of a lower measure next to reused ones is beyond the clean-up.
constexpr double kSpoilt = 0.02;

/// Finds the cavities of the original that are in the new mesh and may be replaced again.
class TetReuse {
 public:
  TetReuse(const NodeSet& nodes, const PeeledMesh& peeled, const MeshPatch& original,
           std::span<const Transform> transforms, const Run& run)
      : nodes_(nodes),
        tets_(peeled.tets),
        peeled_(peeled.tets.size()),
        original_(original),
        transforms_(transforms),
        poll_(run),
        cavities_(original.cavities) {
    std::iota(peeled_.begin(), peeled_.end(), 0);
    find_copies();
    find_images(peeled.slots);
  }

  /// Where the new mesh has other tets than the original had there, of nodes that stayed and with
  /// the same hull, takes the original's for them.
  void undo_flips(const std::function<bool(const Tet&)>& unchanged, const Run& run) {
    const auto may_go = [&](const Tet& t) { return is_of_one_transform(t) && unchanged(t); };
    std::vector<std::uint8_t> found(original_.tets.size(), 0);
    std::vector<Tet> now, now_stay, then, then_stay, both;
    std::vector<std::int32_t> at, originals;  // of `now` and `then`
    for (std::size_t k = 0; k < tets_.size(); ++k) {
      const Tet& t = tets_[k];
      if (image_[k] >= 0) {
        found[image_[k]] = 1;
        both.push_back(t);
      } else if (may_go(t)) {
        at.push_back(static_cast<std::int32_t>(k));
        now.push_back(t);
      } else {
        now_stay.push_back(t);
      }
    }
    if (now.empty()) return;
    for (std::size_t o = 0; o < found.size(); ++o) {
      if (found[o] != 0) continue;
      const Tet copies = renamed(original_.tets[o], copy_);
      if (may_go(copies) && volume_length(nodes_.positions, copies) > 0) {
        originals.push_back(static_cast<std::int32_t>(o));
        then.push_back(copies);
      } else {
        then_stay.push_back(copies);
      }
    }
    if (then.empty()) return;
    const SameHull exchange({now, then, now_stay, then_stay, both}, nodes_.positions.size(), run);
    std::vector<std::uint8_t> goes(tets_.size(), 0);
    for (std::size_t i = 0; i < now.size(); ++i) goes[at[i]] = exchange.first(i) ? 1 : 0;
    leave_out(goes);
    for (std::size_t i = 0; i < then.size(); ++i)
      if (exchange.second(i)) {
        tets_.push_back(then[i]);
        peeled_.push_back(-1);
        image_.push_back(originals[i]);
      }
  }

  ReusedMesh reuse() {
    match();
    while (give_back_spoilt()) {
    }
    return assemble();
  }

 private:
  /// Whether four nodes are unmoved copies with one transformation; -1 is no node.
  [[nodiscard]] bool is_of_one_transform(const Tet& t) const {
    return std::ranges::all_of(t, [&](std::int32_t n) {
      return n >= 0 && t[0] >= 0 && unmoved_[n] && nodes_.transform[n] == nodes_.transform[t[0]];
    });
  }

  /// Leaves out the tets that go, of which 1 is given.
  void leave_out(const std::vector<std::uint8_t>& goes) {
    std::size_t left = 0;
    for (std::size_t k = 0; k < tets_.size(); ++k) {
      if (goes[k] != 0) continue;
      tets_[left] = tets_[k];
      peeled_[left] = peeled_[k];
      image_[left++] = image_[k];
    }
    tets_.resize(left);
    peeled_.resize(left);
    image_.resize(left);
  }

  void find_copies() {
    unmoved_.assign(nodes_.size(), 0);
    copy_.assign(original_.positions.size(), -1);
    for (std::int32_t n = 0; n < nodes_.size(); ++n) {
      const std::int32_t o = nodes_.original[n];
      if (o < 0) continue;
      unmoved_[n] =
          nodes_.positions[n] == transforms_[nodes_.transform[n]].apply(original_.positions[o]);
      if (unmoved_[n]) copy_[o] = n;
    }
  }

  void find_images(std::span<const std::int32_t> slots) {
    std::vector<std::int32_t> at_slot(original_.inside.size(), -1);  // the original's peeled tet
    std::int32_t next = 0;
    for (std::size_t s = 0; s < at_slot.size(); ++s)
      if (original_.inside[s] != 0) at_slot[s] = next++;
    std::vector<std::uint8_t> taken(original_.tets.size(), 0);
    std::vector<std::int32_t> others;  // tets not in the slot of their original
    image_.assign(tets_.size(), -1);
    for (std::size_t k = 0; k < tets_.size(); ++k) {
      poll_();
      if (!is_of_one_transform(tets_[k])) continue;
      const Tet originals = renamed(tets_[k], nodes_.original);
      const auto slot = static_cast<std::size_t>(slots[k]);
      const std::int32_t o = slot < at_slot.size() ? at_slot[slot] : -1;
      if (o >= 0 && original_.tets[o] == originals) {
        image_[k] = o;
        taken[o] = 1;
      } else {
        others.push_back(static_cast<std::int32_t>(k));
      }
    }
    const TetIndex index(original_.tets, taken, original_.positions.size(), false, poll_);
    for (const std::int32_t k : others) image_[k] = index.find(renamed(tets_[k], nodes_.original));
  }

  void match() {
    std::vector<std::uint32_t> found(cavities_.list.size(), 0);
    std::vector<std::int32_t> transform(cavities_.list.size(), -1);
    std::vector<std::uint8_t> whole(cavities_.list.size(), 1);
    for (std::size_t k = 0; k < tets_.size(); ++k) {
      if (image_[k] < 0) continue;
      const std::int32_t t = nodes_.transform[tets_[k][0]];
      const std::int32_t cavity = cavities_.of_tet[image_[k]];
      if (cavity < 0) continue;
      if (transform[cavity] < 0) transform[cavity] = t;
      if (transform[cavity] != t) whole[cavity] = 0;
      ++found[cavity];
    }
    // A cavity all of whose Delaunay tets are in the new mesh, with one transformation, is reused:
    // its output tets, with their nodes renamed to the copies.
    cavity_tets_.resize(cavities_.list.size());
    reused_cavity_.assign(cavities_.list.size(), 0);
    for (std::size_t p = 0; p < cavities_.list.size(); ++p) {
      if (!whole[p] || found[p] != cavities_.list[p].delaunay.size()) continue;
      // Output tets may have nodes that none of the cavity's Delaunay tets has.
      const auto came_along = [&](std::int32_t n) {
        return copy_[n] >= 0 && nodes_.transform[copy_[n]] == transform[p];
      };
      const auto& output = cavities_.list[p].output;
      if (!std::ranges::all_of(output, [&](std::int32_t d) {
            return std::ranges::all_of(original_.output[d], came_along);
          }))
        continue;
      reused_cavity_[p] = 1;
      for (const std::int32_t d : output)
        cavity_tets_[p].push_back(renamed(original_.output[d], copy_));
    }
    reused_.assign(tets_.size(), 0);
    for (std::size_t k = 0; k < tets_.size(); ++k)
      reused_[k] = image_[k] >= 0 &&
                   (cavities_.of_tet[image_[k]] < 0 || reused_cavity_[cavities_.of_tet[image_[k]]]);
  }

  [[nodiscard]] bool stands_for_itself(std::size_t k) const {
    return image_[k] < 0 || cavities_.of_tet[image_[k]] < 0;
  }

  /// Output position where a reused tet holds the node, else that of the Delaunay mesh.
  [[nodiscard]] std::vector<Vec3> positions() const {
    std::vector<Vec3> p = nodes_.positions;
    for (std::int32_t n = 0; n < nodes_.size(); ++n)
      if (held_[n])
        p[n] = transforms_[nodes_.transform[n]].apply(original_.output_nodes[nodes_.original[n]]);
    return p;
  }

  void hold_nodes() {
    held_.assign(nodes_.size(), 0);
    std::fill_n(held_.begin(), nodes_.interface_nodes, 1);
    for (std::size_t k = 0; k < tets_.size(); ++k)
      if (reused_[k] && stands_for_itself(k))
        for (const std::int32_t n : tets_[k]) held_[n] = 1;
    for (std::size_t p = 0; p < cavity_tets_.size(); ++p)
      if (reused_cavity_[p])
        for (const Tet& t : cavity_tets_[p])
          for (const std::int32_t n : t) held_[n] = 1;
  }

  /// Takes back what was reused at the nodes of tets that the output positions have spoilt.
  /// Returns whether anything was.
  bool give_back_spoilt() {
    hold_nodes();
    const std::vector<Vec3> p = positions();
    std::vector<std::uint8_t> release(nodes_.size(), 0);
    bool any = false;
    for (std::size_t k = 0; k < tets_.size(); ++k) {
      poll_();
      if (reused_[k]) continue;
      const Tet& t = tets_[k];
      if (!held_[t[0]] && !held_[t[1]] && !held_[t[2]] && !held_[t[3]]) continue;
      const double now = volume_length(p, t);
      if (now >= kSpoilt) continue;
      const auto& m = nodes_.positions;
      if (volume_length(m, t) <= now) continue;
      const auto spoils = [&](std::int32_t n) { return held_[n] && p[n] != m[n]; };
      bool released = false;
      for (const std::int32_t n : t)
        if (n >= nodes_.interface_nodes && spoils(n)) release[n] = 1, released = true;
      if (!released && std::ranges::any_of(t, spoils)) throw PatchTooSmall{"reusing improved tets"};
      any |= released;
    }
    if (!any) return false;
    const auto touched = [&](const Tet& t) {
      return release[t[0]] || release[t[1]] || release[t[2]] || release[t[3]];
    };
    for (std::size_t q = 0; q < cavity_tets_.size(); ++q)
      if (reused_cavity_[q] && std::any_of(cavity_tets_[q].begin(), cavity_tets_[q].end(), touched))
        reused_cavity_[q] = 0;
    for (std::size_t k = 0; k < tets_.size(); ++k) {
      if (!reused_[k]) continue;
      const std::int32_t cavity = cavities_.of_tet[image_[k]];
      if (touched(tets_[k])) {
        reused_[k] = 0;
        if (cavity >= 0) reused_cavity_[cavity] = 0;
      }
    }
    for (std::size_t k = 0; k < tets_.size(); ++k)
      if (reused_[k] && !stands_for_itself(k) && !reused_cavity_[cavities_.of_tet[image_[k]]])
        reused_[k] = 0;
    return true;
  }

  ReusedMesh assemble() {
    ReusedMesh result;
    result.mesh.nodes = positions();
    result.mesh.tets.reserve(tets_.size());
    result.dirty.reserve(tets_.size());
    result.same.peeled.reserve(tets_.size());
    result.same.output.reserve(tets_.size());
    const auto add = [&](const Tet& tet, bool dirty, std::int32_t peeled, std::int32_t output) {
      result.mesh.tets.push_back(tet);
      result.dirty.push_back(dirty ? 1 : 0);
      result.same.peeled.push_back(peeled);
      result.same.output.push_back(output);
    };
    for (std::size_t k = 0; k < tets_.size(); ++k) {
      if (reused_[k] && !stands_for_itself(k)) continue;  // its cavity's tets are added below
      add(tets_[k], !reused_[k], peeled_[k], image_[k] < 0 ? -1 : cavities_.same[image_[k]]);
    }
    for (std::size_t p = 0; p < cavity_tets_.size(); ++p) {
      if (!reused_cavity_[p]) continue;
      for (std::size_t i = 0; i < cavity_tets_[p].size(); ++i)
        add(cavity_tets_[p][i], false, -1, cavities_.list[p].output[i]);
    }
    return result;
  }

  const NodeSet& nodes_;
  std::vector<Tet> tets_;  ///< the new Delaunay mesh's; the original's where flips were undone
  std::vector<std::int32_t> peeled_;  ///< by tet: that of the new Delaunay mesh, or -1
  const MeshPatch& original_;
  std::span<const Transform> transforms_;
  Polling poll_;
  const Cavities& cavities_;
  std::vector<std::uint8_t> unmoved_;  ///< by node: still the exact copy of its original
  std::vector<std::int32_t> copy_;     ///< by node of the original: its unmoved copy, or -1
  std::vector<std::uint8_t> held_;     ///< by node: 1 at reused tets and at the interface
  std::vector<std::int32_t> image_;    ///< by tet: the same Delaunay tet of the original, or -1
  std::vector<std::uint8_t> reused_;   ///< by tet
  std::vector<std::uint8_t> reused_cavity_;    ///< by cavity
  std::vector<std::vector<Tet>> cavity_tets_;  ///< by cavity: cleaned-up tets over the new nodes
};

}  // namespace

ReusedMesh reuse_improved_tets(const NodeSet& nodes, const PeeledMesh& peeled,
                               const MeshPatch& original, std::span<const Transform> transforms,
                               const std::function<bool(const Tet&)>& unchanged, const Run& run) {
  TetReuse reuse(nodes, peeled, original, transforms, run);
  if (unchanged) reuse.undo_flips(unchanged, run);
  return reuse.reuse();
}

}  // namespace remeshd
