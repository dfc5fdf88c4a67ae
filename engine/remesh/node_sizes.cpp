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
  double most_off = 1.25;  ///< largest ratio of two edge lengths that count as the same
  double around = 1;       ///< x edge length: no material is further from its nearest node
};
constexpr ResizeLimits kResizeLimits;

bool differ(double a, double b) {
  return a > kResizeLimits.most_off * b || b > kResizeLimits.most_off * a;
}

/// Whether it is known what the parent's nodes were made for: older versions stored sized meshes
/// without that.
bool is_known(const Revision& parent) {
  return parent.options.sizing.even || !parent.output.node_sizes.empty();
}

/// The edge length that the parent's node was made for.
double made_for(const Revision& parent, std::int32_t node) {
  return parent.options.sizing.even ? parent.edge_length : parent.output.node_sizes[node];
}

/// Whether two size fields follow from their boundaries by the same rules: then only what changed
/// of these, and what is near it, is a reason for them to differ. They may differ a little
/// elsewhere: the thickness of a wall is measured from pieces of its faces, and a face that has
/// changed anywhere is divided into other pieces.
bool same_rules(const Revision& parent, const Revision& wanted) {
  return parent.options.sizing == wanted.options.sizing &&
         parent.edge_length == wanted.edge_length &&
         parent.rules_weakening == wanted.rules_weakening &&
         parent.model.sizes == wanted.model.sizes && parent.dense_places == wanted.dense_places;
}

/// Tells how far from a change of the model it may be the reason for other edge lengths.
class Reach {
 public:
  Reach(const CopyPlan& plan, const Revision& parent, const Revision& wanted, double least)
      : plan_(plan),
        sizing_(wanted.options.sizing),
        least_(least),
        everywhere_(!same_rules(parent, wanted)) {}

  /// Whether a change may be why the length at a place is `now` and was `before`. A change asks for
  /// the least length or more, and lengths grow with the distance from it; or it is the other side
  /// of a wall, `layers` edge lengths away.
  [[nodiscard]] bool holds(const Vec3& p, double before, double now) const {
    if (everywhere_) return true;
    const double longer = std::fmax(before, now);
    const double grown = (longer - least_) / (sizing_.growth - 1);
    return plan_.in_changed(p, std::fmax(grown, sizing_.layers * longer));
  }

 private:
  const CopyPlan& plan_;
  const Sizing& sizing_;
  double least_;  ///< least edge length
  bool everywhere_;
};

}  // namespace

CowVector<double> made_for(const Revision& parent, const Revision& revision, const CopyPlan* plan,
                           const Run& run) {
  if (revision.options.sizing.even) return {};
  const OutputMesh& output = revision.output;
  const SizeField& sizes = *revision.sizes;
  const CowVector<Vec3>& positions = revision.delaunay_state->positions();  // as in `resized`
  const bool known = is_known(parent), same_tets = plan == nullptr;
  std::optional<Reach> reach;
  if (plan != nullptr) reach.emplace(*plan, parent, revision, sizes.least());
  std::vector<double> all(output.mesh.nodes.size());
  in_blocks(all.size(), kDearBlock, run, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const bool kept = known && (same_tets || output.map.node_origin[n] == NodeOrigin::Kept);
      const double was = kept ? made_for(parent, output.map.original_node[n]) : 0;
      const double now = kept && same_tets ? was : sizes(positions[n]);
      // `resized` has seen to nodes that are off: one that was kept all the same suits its place.
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
