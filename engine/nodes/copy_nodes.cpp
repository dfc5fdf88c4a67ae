#include "engine/nodes/copy_nodes.h"

#include <algorithm>
#include <bit>
#include <optional>

#include "engine/base/random.h"
#include "engine/mesh/grouping.h"

namespace remeshd {

namespace {

struct CopyLimits {
  double into_tet = 0.01;  ///< x the way to its centroid, where material next to a node is tried
  /// Nodes of a regular mesh in a layer as thick as the edge length, over the nodes on its wall:
  /// sqrt(2) / l^3 in the volume, 2 / (sqrt(3) l^2) on the wall.
  double nodes_per_layer = 1.2247;
  int bisections = 12;  ///< to find the wall
};
constexpr CopyLimits kCopyLimits;

Grouping<Tet> tets_at_nodes(const OriginalNodes& original) {
  return grouped<Tet>(original.positions.size(), [&](const auto& visit) {
    for (const Tet& t : original.tets)
      for (const std::int32_t n : t) visit(n, t);
  });
}

/// Transformations in the order in which their features copy.
std::vector<std::int32_t> copying_order(const CopyPlan& plan) {
  std::vector<std::int32_t> order;
  for (const SourceFeature& s : plan.sources())
    if (std::find(order.begin(), order.end(), s.transform) == order.end())
      order.push_back(s.transform);
  return order;
}

class Copier {
 public:
  Copier(const CopyPlan& plan, const OriginalNodes& original, const SizeField& sizes)
      : plan_(plan),
        original_(original),
        sizes_(sizes),
        at_(tets_at_nodes(original)),
        extent_(plan.transforms().size()) {
    for (const SourceFeature& s : plan.sources())
      extent_[s.transform].push_back(plan.original().solids()[s.original].bounds());
  }

  /// Whether the node may belong to material that this transformation moves.
  [[nodiscard]] bool reached(std::int32_t n, std::int32_t t) const {
    return std::any_of(extent_[t].begin(), extent_[t].end(), [&](const Box& box) {
      return box.contains(original_.positions[n], plan_.probe());
    });
  }

  /// Whether this transformation copies the node, without setting it back.
  [[nodiscard]] bool is_copied(std::int32_t n, std::int32_t t) const {
    const Transform& x = plan_.transforms()[t];
    const Vec3& q = original_.positions[n];
    if (original_.supports[n].kind == Support::Kind::Interior) return plan_(x.apply(q)) == t;
    for (const Tet& tet : at_[n])
      if (plan_(x.apply(q + kCopyLimits.into_tet * (centroid(original_.positions, tet) - q))) == t)
        return true;
    return false;
  }

  /// Where the node is set back to if this transformation would move it outside but copies material
  /// of its tets; nothing where it does not, or the node is one of those left out for lost volume.
  [[nodiscard]] std::optional<Vec3> set_back(std::int32_t n, std::int32_t t) const {
    const Transform& x = plan_.transforms()[t];
    const Vec3 p = x.apply(original_.positions[n]);
    if (plan_(p) != CopyPlan::kOutside) return std::nullopt;
    Vec3 middle{};
    int count = 0;
    for (const Tet& tet : at_[n]) {
      const Vec3 c = x.apply(centroid(original_.positions, tet));
      if (plan_(c) != t) continue;
      middle += c;
      ++count;
    }
    if (count == 0) return std::nullopt;
    middle = middle / count;
    if (plan_(middle) != t) return std::nullopt;
    double outside = 0, inside = 1;
    for (int k = 0; k < kCopyLimits.bisections; ++k) {
      const double half = 0.5 * (outside + inside);
      (plan_(p + half * (middle - p)) == t ? inside : outside) = half;
    }
    const Vec3 place = p + inside * (middle - p);
    const double lost =
        kCopyLimits.nodes_per_layer * distance(p, place) / sizes_(original_.positions[n]);
    Random draw(static_cast<std::uint64_t>(n) ^ std::bit_cast<std::uint64_t>(lost));
    if (draw.uniform() < lost) return std::nullopt;
    return place;
  }

 private:
  const CopyPlan& plan_;
  const OriginalNodes& original_;
  const SizeField& sizes_;
  const Grouping<Tet> at_;                ///< tets by node
  std::vector<std::vector<Box>> extent_;  ///< by transformation: original boxes of its features
};

}  // namespace

CopiedNodes copy_nodes(const CopyPlan& plan, const OriginalNodes& original, const SizeField& sizes,
                       const Run& run) {
  CopiedNodes nodes;
  const Copier copier(plan, original, sizes);
  const std::vector<std::int32_t> order = copying_order(plan);
  const auto add = [&](std::int32_t n, std::int32_t t, const Vec3& place, bool free) {
    nodes.add(place, original.supports[n], free ? NodeState::Free : NodeState::Fixed, n, t);
  };
  Polling poll(run);
  for (const std::int32_t n : original.near) {
    poll();
    bool copied = false;
    for (const std::int32_t t : order) {
      copied = copier.reached(n, t) && copier.is_copied(n, t);
      if (!copied) continue;
      add(n, t, plan.transforms()[t].apply(original.positions[n]), false);
      break;
    }
    for (std::size_t k = 0; k < order.size() && !copied; ++k) {
      if (!copier.reached(n, order[k])) continue;
      const std::optional<Vec3> place = copier.set_back(n, order[k]);
      copied = place.has_value();
      if (copied) add(n, order[k], *place, true);
    }
  }
  return nodes;
}

}  // namespace remeshd
