#include "engine/second_order/mid_nodes.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/second_order/curved_edges.h"
#include "engine/second_order/jacobian.h"
#include "engine/second_order/mid_numbers.h"

namespace remeshd {

namespace {

struct MidLimits {
  double same_place = 1e-6;     ///< x length of an edge: a mid-node so near to where it was is kept
  double bend = 0.5;            ///< x length of an edge: one that would bend more is straightened
  double least_jacobian = 0.1;  ///< x that of the straight tet
};
constexpr MidLimits kLimits;

enum class Bend : std::uint8_t { None, Curved, Straightened };

/// Mid-nodes as they come to be.
class Mids {
 public:
  Mids(const Revision& original, const Revision& revision, MidNumbers numbers,
       std::span<const CurvedEdge> curved)
      : output_(revision.output),
        original_(original.output),
        numbers_(std::move(numbers)),
        places_(size()),
        origins_(size(), NodeOrigin::New),
        transforms_(size(), -1),
        bends_(size(), Bend::None),
        same_tets_(revision.report.strategy == MeshStrategy::Morphed) {
    for (std::size_t mid = 0; mid < size(); ++mid) places_[mid] = middle(mid);
    for (const auto& [mid, place] : curved) {
      const bool too_far = distance(place, places_[mid]) > kLimits.bend * length(mid);
      bends_[mid] = too_far ? Bend::Straightened : Bend::Curved;
      if (!too_far) places_[mid] = place;
    }
    keep();
  }

  /// Straightens edges until no tet may be turned over.
  void straighten(const Run& run) {
    std::vector<std::uint8_t> is_kept(size());
    for (std::size_t mid = 0; mid < size(); ++mid)
      is_kept[mid] = origins_[mid] == NodeOrigin::Kept ? 1 : 0;
    // A new tet may have the edges of old ones.
    std::vector<std::size_t> suspects = tets_where([&](std::size_t t) {
      return output_.map.original_tet[t] < 0 ||
             std::ranges::any_of(numbers_.of_tets[t], [&](std::int32_t m) { return !is_kept[m]; });
    });
    while (!suspects.empty()) {
      run.poll();
      std::vector<std::uint8_t> straightened(size(), 0);
      bool any = false;
      for (const std::size_t t : suspects) {
        const std::int32_t worst = most_bent(numbers_.of_tets[t]);
        if (worst < 0 || least_jacobian(tet(t)) >= kLimits.least_jacobian) continue;
        straighten(worst);
        straightened[worst] = 1;
        any = true;
      }
      if (!any) return;
      suspects = tets_where([&](std::size_t t) {
        return std::ranges::any_of(numbers_.of_tets[t],
                                   [&](std::int32_t m) { return straightened[m] != 0; });
      });
    }
  }

  /// `next_id`: the first permanent id that is free.
  [[nodiscard]] MidNodes take(std::uint64_t next_id) && {
    const MidNodes& was = original_.mids;
    std::vector<std::uint64_t> ids(size());
    MidNodes mids;
    for (std::size_t mid = 0; mid < size(); ++mid) {
      const std::int32_t o = numbers_.original[mid];
      ids[mid] = o >= 0 ? was.ids[o] : next_id++;
      if (bends_[mid] == Bend::Straightened)
        mids.straightened.push_back(static_cast<std::int32_t>(mid));
    }
    mids.positions = {std::span<const Vec3>(places_), was.positions};
    mids.edges = {std::span<const std::array<std::int32_t, 2>>(numbers_.edges), was.edges};
    mids.of_tets = {std::span<const std::array<std::int32_t, 6>>(numbers_.of_tets), was.of_tets};
    mids.ids = {std::span<const std::uint64_t>(ids), was.ids};
    mids.origin = {std::span<const NodeOrigin>(origins_), was.origin};
    mids.original = {std::span<const std::int32_t>(numbers_.original), was.original};
    mids.transform = {std::span<const std::int32_t>(transforms_), was.transform};
    mids.next_id = next_id;
    return mids;
  }

 private:
  [[nodiscard]] std::size_t size() const { return numbers_.edges.size(); }
  [[nodiscard]] const Vec3& corner(std::size_t mid, int k) const {
    return output_.mesh.nodes[numbers_.edges[mid][k]];
  }
  [[nodiscard]] Vec3 middle(std::size_t mid) const {
    return 0.5 * (corner(mid, 0) + corner(mid, 1));
  }
  [[nodiscard]] double length(std::size_t mid) const {
    return distance(corner(mid, 0), corner(mid, 1));
  }
  [[nodiscard]] QuadraticTet tet(std::size_t t) const {
    QuadraticTet tet;
    for (int k = 0; k < 4; ++k) tet.corners[k] = output_.mesh.nodes[output_.mesh.tets[t][k]];
    for (int k = 0; k < 6; ++k) tet.mids[k] = places_[numbers_.of_tets[t][k]];
    return tet;
  }

  template <class Holds>
  [[nodiscard]] std::vector<std::size_t> tets_where(const Holds& holds) const {
    std::vector<std::size_t> tets;
    for (std::size_t t = 0; t < numbers_.of_tets.size(); ++t)
      if (holds(t)) tets.push_back(t);
    return tets;
  }

  /// The transformation that both corners are kept by; -1 where there is none.
  [[nodiscard]] std::int32_t common_transform(std::size_t mid) const {
    const NodeMap& map = output_.map;
    const auto [a, b] = numbers_.edges[mid];
    const bool kept =
        map.node_origin[a] == NodeOrigin::Kept && map.node_origin[b] == NodeOrigin::Kept;
    return kept && map.node_transform[a] == map.node_transform[b] ? map.node_transform[a] : -1;
  }

  /// Puts mid-nodes of the original where they were, where that is still right.
  void keep() {
    const MidNodes& was = original_.mids;
    for (std::size_t mid = 0; mid < size(); ++mid) {
      const std::int32_t o = numbers_.original[mid];
      if (o < 0) continue;
      origins_[mid] = NodeOrigin::Moved;
      transforms_[mid] = output_.map.node_transform[numbers_.edges[mid][0]];
      const bool stays_straight =
          bends_[mid] == Bend::Curved && std::ranges::binary_search(was.straightened, o);
      // Lest the mid-node jumps from edit to edit.
      if (stays_straight && same_tets_) straighten(static_cast<std::int32_t>(mid));
      const std::int32_t transform = common_transform(mid);
      if (transform < 0) continue;
      const Vec3 place = output_.map.transforms[transform].apply(was.positions[o]);
      if (!stays_straight && distance(place, places_[mid]) > kLimits.same_place * length(mid))
        continue;
      places_[mid] = place;
      origins_[mid] = NodeOrigin::Kept;
      transforms_[mid] = transform;
      if (stays_straight) bends_[mid] = Bend::Straightened;
    }
  }

  /// The mid-node of a tet that is furthest from the middle of its edge, x the edge's length; a
  /// kept one only where no other is curved. -1 where no edge is curved.
  [[nodiscard]] std::int32_t most_bent(const std::array<std::int32_t, 6>& of_tet) const {
    std::int32_t most = -1;
    std::pair<bool, double> furthest{false, 0};
    for (const std::int32_t mid : of_tet) {
      if (bends_[mid] != Bend::Curved) continue;
      const std::pair bent{origins_[mid] != NodeOrigin::Kept,
                           distance(places_[mid], middle(mid)) / length(mid)};
      if (most >= 0 && bent <= furthest) continue;
      most = mid;
      furthest = bent;
    }
    return most;
  }

  void straighten(std::int32_t mid) {
    places_[mid] = middle(mid);
    bends_[mid] = Bend::Straightened;
    if (origins_[mid] == NodeOrigin::Kept) origins_[mid] = NodeOrigin::Moved;
  }

  const OutputMesh& output_;
  const OutputMesh& original_;
  MidNumbers numbers_;
  std::vector<Vec3> places_;
  std::vector<NodeOrigin> origins_;
  std::vector<std::int32_t> transforms_;
  std::vector<Bend> bends_;
  bool same_tets_;  ///< whether the tets are the original's, over nodes that followed the surfaces
};

}  // namespace

void add_mid_nodes(const Revision& parent, Revision& revision, const Run& run) {
  MidNumbers numbers = number_mids(revision.output, parent.output, run);
  const std::vector<CurvedEdge> curved = curved_edges(revision, numbers, run);
  Mids mids(parent, revision, std::move(numbers), curved);
  mids.straighten(run);
  revision.output.mids = std::move(mids).take(parent.output.mids.next_id);
  Counts& counts = revision.report.counts;
  counts.mid_nodes = static_cast<std::uint32_t>(revision.output.mids.positions.size());
  counts.straight_edges = static_cast<std::uint32_t>(revision.output.mids.straightened.size());
}

}  // namespace remeshd
