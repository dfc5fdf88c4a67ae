#include "engine/remesh/node_sizes.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "engine/base/parallel.h"
#include "engine/base/region.h"
#include "engine/nodes/nearest.h"
#include "engine/revision/delaunay_state.h"

namespace remeshd {
namespace {

struct ResizeLimits {
  double most_off = 1.25;  ///< of a length wanted and one that was
  double around = 1;       ///< x edge length: nothing nearest to a node is further away
};
constexpr ResizeLimits kResizeLimits;

bool differ(double a, double b) {
  return a > kResizeLimits.most_off * b || b > kResizeLimits.most_off * a;
}

/// Whether that is known: revisions that are not even were stored without it once.
bool is_known(const Revision& parent) {
  return parent.options.sizing.even || !parent.output.node_sizes.empty();
}

/// What the parent's node was made for.
double made_for(const Revision& parent, std::int32_t node) {
  return parent.options.sizing.even ? parent.edge_length : parent.output.node_sizes[node];
}

/// Whether two size fields follow by the same rules from their boundaries: they differ near what
/// changed of these alone. How thin a wall is told by pieces of faces, which lie otherwise wherever
/// a face has changed, so that elsewhere lengths may differ all the same.
bool same_rules(const Revision& parent, const Revision& wanted) {
  return parent.options.sizing == wanted.options.sizing &&
         parent.edge_length == wanted.edge_length &&
         parent.rules_weakening == wanted.rules_weakening &&
         parent.model.sizes == wanted.model.sizes && parent.dense_places == wanted.dense_places;
}

/// How far from a change edge lengths may follow from it.
class Reach {
 public:
  Reach(const CopyPlan& plan, const Revision& parent, const Revision& wanted, double least)
      : plan_(plan),
        sizing_(wanted.options.sizing),
        least_(least),
        everywhere_(!same_rules(parent, wanted)) {}

  /// Whether a change may be why the length at a place is `now` and was `before`: it asks for the
  /// least length or more, which grows from there, or is across a wall.
  [[nodiscard]] bool holds(const Vec3& p, double before, double now) const {
    if (everywhere_) return true;
    const double longer = std::fmax(before, now);
    const double grown = (longer - least_) / (sizing_.growth - 1);
    return plan_.in_changed(p, std::fmax(grown, sizing_.layers * longer));
  }

 private:
  const CopyPlan& plan_;
  const Sizing& sizing_;
  double least_;  ///< of the edge lengths
  bool everywhere_;
};

}  // namespace

CowVector<double> made_for(const Revision& parent, const Revision& revision, const CopyPlan* plan,
                           const Run& run) {
  if (revision.options.sizing.even) return {};
  const OutputMesh& output = revision.output;
  const SizeField& sizes = *revision.sizes;
  const CowVector<Vec3>& positions = revision.delaunay_state->positions();  // as it is asked later
  const bool known = is_known(parent), same_tets = plan == nullptr;
  std::optional<Reach> reach;
  if (plan != nullptr) reach.emplace(*plan, parent, revision, sizes.least());
  std::vector<double> all(output.mesh.nodes.size());
  in_blocks(all.size(), kDearBlock, run, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const bool kept = known && (same_tets || output.map.node_origin[n] == NodeOrigin::Kept);
      const double was = kept ? made_for(parent, output.map.original_node[n]) : 0;
      const double now = kept && same_tets ? was : sizes(positions[n]);
      // What was off has been looked at: a node that stays is right for the length there.
      const auto off = [&] { return differ(was, now) && reach->holds(positions[n], was, now); };
      all[n] = kept && !same_tets && !off() ? was : now;
    }
  });
  return {std::span<const double>(all), parent.output.node_sizes};
}

std::optional<CopyPlan> resized(const CopyPlan& plan, const Revision& parent,
                                const Revision& wanted, const SizeField& sizes, const Run& run) {
  if (wanted.options.sizing.even && parent.options.sizing.even) return {};
  if (!is_known(parent) || plan.identity() < 0 || !plan.copies()) return {};
  const std::vector<Vec3> nodes = parent.delaunay_state->positions().flat();
  const Reach reach(plan, parent, wanted, sizes.least());
  std::vector<std::uint8_t> off(nodes.size());
  in_blocks(nodes.size(), kDearBlock, run, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const double was = made_for(parent, static_cast<std::int32_t>(n)), now = sizes(nodes[n]);
      off[n] = differ(was, now) && reach.holds(nodes[n], was, now) ? 1 : 0;
    }
  });
  std::vector<Vec3> places;
  double longest = 0;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (off[n] == 0) continue;
    places.push_back(nodes[n]);
    longest = std::max({longest, made_for(parent, static_cast<std::int32_t>(n)), sizes(nodes[n])});
  }
  if (places.empty()) return {};
  struct Nearest {
    NearestNode grid;
    std::vector<std::uint8_t> off;
  };
  const auto nearest = std::make_shared<const Nearest>(
      Nearest{NearestNode(nodes, kGridCell * sizes.grid_length()), std::move(off)});
  return plan.with_new_in(
      [nearest](const Vec3& p) { return nearest->off[nearest->grid.nearest(p)] != 0; },
      Region(places, kResizeLimits.around * longest, 1).boxes(), CopyPlan::Anew::InPlace);
}

}  // namespace remeshd
