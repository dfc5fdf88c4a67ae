#include "engine/patch/stitch.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "engine/mesh/grouping.h"
#include "engine/mesh/tet_boxes.h"
#include "engine/patch/node_map.h"
#include "engine/patch/tet_index.h"

namespace remeshd {

namespace {

constexpr double kMostSpare = 0.1;  // x tets: free slots that a revision may keep

/// Numbers for new elements: first those of the elements that go, then further ones at the end.
class FreeNumbers {
 public:
  /// `count`: elements before; `gone`: which of them go, ascending.
  FreeNumbers(std::int32_t count, std::vector<std::int32_t> gone)
      : end_(count), gone_(std::move(gone)) {}

  std::int32_t take() { return used_ < gone_.size() ? gone_[used_++] : end_++; }
  /// More than every number in use once `more` have been taken.
  [[nodiscard]] std::size_t end_after(std::size_t more) const {
    const std::size_t gaps = gone_.size() - used_;
    return static_cast<std::size_t>(end_) + (more > gaps ? more - gaps : 0);
  }

  /// Number of elements once the gaps are closed.
  [[nodiscard]] std::int32_t count() const {
    return end_ - static_cast<std::int32_t>(gone_.size() - used_);
  }
  /// Whether there are gaps that the last ones have to fill.
  [[nodiscard]] bool has_gaps() const { return used_ < gone_.size(); }
  /// By number less `count()`, for the elements from `count()` on: the gap that each one moves to,
  /// -1 where it is a gap itself.
  [[nodiscard]] std::vector<std::int32_t> moves() const {
    std::vector<std::int32_t> to(static_cast<std::size_t>(end_ - count()), 0);
    std::size_t gap = used_;
    for (std::size_t k = used_; k < gone_.size(); ++k)
      if (gone_[k] >= count()) to[gone_[k] - count()] = -1;
    for (std::int32_t& t : to)
      if (t == 0) t = gone_[gap++];
    return to;
  }

 private:
  std::int32_t end_;
  std::vector<std::int32_t> gone_;
  std::size_t used_ = 0;
};

/// Moves the last elements into the gaps.
template <class T>
void close_gaps(CowVector<T>& values, const std::vector<std::int32_t>& moves) {
  const std::size_t count = values.size() - moves.size();
  for (std::size_t k = 0; k < moves.size(); ++k)
    if (moves[k] >= 0) values.set(moves[k], values[count + k]);
  values.resize(count);
}

/// The tets in the order of their lowest nodes.
std::vector<std::int32_t> by_lowest_node(const TetMesh& mesh) {
  auto by_node = grouped<std::int32_t>(mesh.nodes.size(), [&](const auto& visit) {
    for (std::size_t k = 0; k < mesh.tets.size(); ++k)
      visit(std::ranges::min(mesh.tets[k]), static_cast<std::int32_t>(k));
  });
  return std::move(by_node.items);
}

class Stitcher {
 public:
  Stitcher(const Revision& original, const MeshPatch& cut, const PatchMesh& patch,
           const CopyPlan& plan, const Run& run)
      : original_(original), cut_(cut), patch_(patch), plan_(plan), run_(run), poll_(run) {}

  StitchedMesh stitch(CowVector<Support> supports) {
    whole_.mesh = {original_.copied_nodes(), original_.output.mesh.tets};
    whole_.delaunay_state = *original_.delaunay_state;
    whole_.delaunay_state.supports = std::move(supports);
    map_all();
    place_nodes();
    place_tets();
    put_back();
    close_node_gaps();
    close_tet_gaps();
    return std::move(whole_);
  }

 private:
  /// Fills in the map as if all of the original stayed.
  void map_all() {
    NodeMap& map = whole_.map;
    map = map_to_itself(original_, whole_.mesh.nodes, plan_.identity());
    map.transforms = plan_.transforms();
    map.transform_features.resize(map.transforms.size());
    for (const SourceFeature& s : plan_.sources())
      if (map.transform_features[s.transform].empty())
        map.transform_features[s.transform] = original_.model.features[s.original].id;
  }

  void place_nodes() {
    const NodeSet& nodes = patch_.nodes;
    std::vector<std::uint8_t> stays(cut_.nodes.size(), 0);
    for (const std::int32_t o : nodes.original)
      if (o >= 0) stays[o] = 1;
    std::vector<std::int32_t> gone;
    for (std::size_t p = 0; p < stays.size(); ++p)
      if (stays[p] == 0) gone.push_back(cut_.nodes[p]);
    node_places_.emplace(static_cast<std::int32_t>(whole_.mesh.nodes.size()), std::move(gone));
    FreeNumbers& places = *node_places_;
    names_.resize(nodes.positions.size());
    for (std::size_t n = 0; n < names_.size(); ++n)
      names_[n] = nodes.original[n] >= 0 ? cut_.nodes[nodes.original[n]] : places.take();

    NodeMap& map = whole_.map;
    const std::size_t most = std::max<std::size_t>(
        whole_.mesh.nodes.size(), names_.empty() ? 0 : 1 + std::ranges::max(names_));
    whole_.mesh.nodes.resize(most);
    whole_.delaunay_state.supports.resize(most);
    map.node_origin.resize(most);
    map.original_node.resize(most, -1);
    map.node_transform.resize(most);
    const CowVector<Vec3>& then = original_.output.mesh.nodes;
    for (std::size_t n = 0; n < names_.size(); ++n) {
      const std::int32_t at = names_[n];
      whole_.mesh.nodes.set(at, patch_.mesh.nodes[n]);
      whole_.delaunay_state.supports.set(at, nodes.supports[n]);
      const bool copied = nodes.original[n] >= 0;
      map.original_node.set(at, copied ? at : -1);
      map.node_transform.set(at, nodes.transform[n]);
      map.node_origin.set(
          at, !copied ? NodeOrigin::New
              : patch_.mesh.nodes[n] == plan_.transforms()[nodes.transform[n]].apply(then[at])
                  ? NodeOrigin::Kept
                  : NodeOrigin::Moved);
    }
  }

  void place_tets() {
    const NodeSet& nodes = patch_.nodes;
    const std::vector<Tet>& tets = patch_.mesh.tets;
    std::vector<std::int32_t> was = patch_.same.output;
    was.resize(tets.size(), -1);
    std::vector<std::uint8_t> stays(cut_.output.size(), 0);
    for (const std::int32_t d : was)
      if (d >= 0) stays[d] = 1;
    const TetIndex index(cut_.output, stays, cut_.nodes.size(),
                         patch_.cavities == CavityExtent::Least, poll_);
    for (std::size_t k = 0; k < tets.size(); ++k) {
      poll_();
      if (was[k] >= 0) continue;
      const Tet originals = renamed(tets[k], nodes.original);
      if (std::ranges::any_of(originals, [](std::int32_t o) { return o < 0; })) continue;
      was[k] = index.find(originals);
      if (was[k] >= 0) stays[was[k]] = 1;
    }
    std::vector<std::int32_t> gone;
    for (std::size_t d = 0; d < stays.size(); ++d)
      if (stays[d] == 0) gone.push_back(cut_.output_tet[d]);
    std::ranges::sort(gone);
    tet_places_.emplace(static_cast<std::int32_t>(whole_.mesh.tets.size()), std::move(gone));
    FreeNumbers& places = *tet_places_;
    NodeMap& map = whole_.map;
    const std::size_t end = places.end_after(std::ranges::count(was, -1));
    whole_.mesh.tets.resize(end);
    map.original_tet.resize(end, -1);
    whole_.new_tets.resize(tets.size());
    std::vector<std::int32_t> order(tets.size());
    std::iota(order.begin(), order.end(), 0);
    // Tets near in space should be near in memory. In an edit they are: they take numbers of tets
    // that were there.
    if (cut_.output_tet.empty()) order = by_lowest_node(patch_.mesh);
    for (const std::int32_t k : order) {
      const std::int32_t at = was[k] >= 0 ? cut_.output_tet[was[k]] : places.take();
      whole_.new_tets[k] = at;
      const Tet tet = renamed(tets[k], names_);
      const bool kept = was[k] >= 0 && std::ranges::all_of(tet, [&](std::int32_t n) {
                          return map.node_origin[n] == NodeOrigin::Kept &&
                                 map.node_transform[n] == map.node_transform[tet[0]];
                        });
      whole_.mesh.tets.set(at, tet);
      map.original_tet.set(at, kept ? at : -1);
    }
  }

  /// Puts the patch's Delaunay mesh back, with its cavities and the output tet of each slot.
  void put_back() {
    DelaunayState& delaunay_state = whole_.delaunay_state;
    const std::vector<std::int32_t> slot = delaunay_state.mesh.put_back(
        patch_.delaunay, cut_.cut, names_, static_cast<std::int32_t>(whole_.mesh.nodes.size()));
    delaunay_state.tet_of_slot.resize(delaunay_state.mesh.slots(), DelaunayState::kOutside);
    std::vector<std::int32_t> tet_of_slot(slot.size(), DelaunayState::kOutside);  // of the patch
    const Cavities cavities =
        find_cavities(patch_.peeled.tets, patch_.mesh.tets, patch_.same.peeled, names_.size(),
                      patch_.cavities, run_);
    std::vector<std::int32_t> free = cut_.parent_cavities;
    std::vector<std::int32_t> number;
    for (const std::int32_t c : free) delaunay_state.cavities.edit(c) = {};
    std::ranges::sort(free, std::greater());
    for (const Cavity& cavity : cavities.list) {
      if (free.empty()) {
        free.push_back(static_cast<std::int32_t>(delaunay_state.cavities.size()));
        delaunay_state.cavities.resize(delaunay_state.cavities.size() + 1);
      }
      number.push_back(free.back());
      free.pop_back();
      Cavity& out = delaunay_state.cavities.edit(number.back());
      for (const std::int32_t k : cavity.delaunay)
        out.delaunay.push_back(slot[patch_.peeled.slots[k]]);
      for (const std::int32_t k : cavity.output) out.output.push_back(whole_.new_tets[k]);
    }
    for (std::size_t k = 0; k < patch_.peeled.slots.size(); ++k)
      tet_of_slot[patch_.peeled.slots[k]] = cavities.same[k] >= 0
                                                ? whole_.new_tets[cavities.same[k]]
                                                : -2 - number[cavities.of_tet[k]];
    for (std::size_t s = 0; s < slot.size(); ++s)
      if (slot[s] >= 0) delaunay_state.tet_of_slot.set(slot[s], tet_of_slot[s]);
    for (std::size_t s = 0; s < cut_.cut.slots.size(); ++s)
      if (slot[s] < 0 && !delaunay_state.mesh.in_use(cut_.cut.slots[s]))
        delaunay_state.tet_of_slot.set(cut_.cut.slots[s], DelaunayState::kOutside);
    const std::size_t spare = delaunay_state.mesh.slots() - delaunay_state.mesh.size();
    if (static_cast<double>(spare) > kMostSpare * static_cast<double>(delaunay_state.mesh.size()))
      close_slot_gaps();
  }

  void close_slot_gaps() {
    DelaunayState& delaunay_state = whole_.delaunay_state;
    const std::vector<std::int32_t> to = delaunay_state.mesh.close_gaps();
    std::vector<std::int32_t> tet_of_slot(delaunay_state.mesh.slots());
    for (std::size_t s = 0; s < to.size(); ++s)
      if (to[s] >= 0) tet_of_slot[to[s]] = delaunay_state.tet_of_slot[s];
    delaunay_state.tet_of_slot = CowVector<std::int32_t>(tet_of_slot);
    for (std::size_t c = 0; c < delaunay_state.cavities.size(); ++c)
      for (std::int32_t& s : delaunay_state.cavities.edit(c).delaunay) s = to[s];
  }

  void close_node_gaps() {
    const FreeNumbers& places = *node_places_;
    if (!places.has_gaps()) return;
    const std::vector<std::int32_t> moves = places.moves();
    const std::int32_t count = places.count();
    whole_.delaunay_state.mesh.rename_last(moves, count);
    const CowVector<Tet> tets = whole_.mesh.tets;
    const OutputMesh& then = original_.output;
    std::vector<Vec3> last;  // positions in the original of nodes that get other numbers
    for (std::size_t n = count; n < then.mesh.nodes.size(); ++n) last.push_back(then.mesh.nodes[n]);
    const PagesNear at_last(then.mesh.tets, original_.boxes, last);
    for (std::size_t k = 0; k < tets.pages(); ++k) {
      if (!at_last.may_be(tets, k)) continue;
      std::size_t t = k * tets.kPage;
      for (const Tet& tet : tets.page(k)) {
        if (tet[0] >= count || tet[1] >= count || tet[2] >= count || tet[3] >= count)
          for (std::int32_t& n : whole_.mesh.tets.edit(t))
            if (n >= count) n = moves[n - count];
        ++t;
      }
    }
    close_gaps(whole_.mesh.nodes, moves);
    close_gaps(whole_.delaunay_state.supports, moves);
    close_gaps(whole_.map.node_origin, moves);
    close_gaps(whole_.map.original_node, moves);
    close_gaps(whole_.map.node_transform, moves);
  }

  void close_tet_gaps() {
    const FreeNumbers& places = *tet_places_;
    if (!places.has_gaps()) return;
    const std::vector<std::int32_t> moves = places.moves();
    const std::int32_t count = places.count();
    const auto moved = [&](std::int32_t t) { return t < count ? t : moves[t - count]; };
    DelaunayState& delaunay_state = whole_.delaunay_state;
    const CowVector<std::int32_t> tet_of_slot = delaunay_state.tet_of_slot;
    tet_of_slot.for_each([&](std::size_t s, std::int32_t t) {
      if (t >= count) delaunay_state.tet_of_slot.edit(s) = moved(t);
    });
    for (std::size_t c = 0; c < delaunay_state.cavities.size(); ++c) {
      const std::vector<std::int32_t>& tets = delaunay_state.cavities[c].output;
      if (std::ranges::any_of(tets, [&](std::int32_t t) { return t >= count; }))
        for (std::int32_t& t : delaunay_state.cavities.edit(c).output) t = moved(t);
    }
    for (std::int32_t& t : whole_.new_tets) t = moved(t);
    close_gaps(whole_.mesh.tets, moves);
    close_gaps(whole_.map.original_tet, moves);
  }

  const Revision& original_;
  const MeshPatch& cut_;
  const PatchMesh& patch_;
  const CopyPlan& plan_;
  const Run& run_;
  Polling poll_;
  StitchedMesh whole_;
  std::vector<std::int32_t> names_;  ///< by node of the patch: its number in the whole
  std::optional<FreeNumbers> node_places_, tet_places_;
};

}  // namespace

StitchedMesh stitch(const Revision& original, CowVector<Support> supports, const MeshPatch& cut,
                    const PatchMesh& patch, const CopyPlan& plan, const Run& run) {
  return Stitcher(original, cut, patch, plan, run).stitch(std::move(supports));
}

}  // namespace remeshd
