#include "engine/remesh/node_sizes.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

#include "engine/base/parallel.h"
#include "engine/base/region.h"
#include "engine/nodes/nearest.h"
#include "engine/revision/delaunay_state.h"
#include "engine/sizing/size_rules.h"

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

/// Whether the size field that the parent's nodes were made for and the one wanted now follow from
/// their boundaries by the same rules. Then the fields differ for a reason only near what changed
/// of the boundaries. They may differ a little elsewhere: the thickness of a wall is measured on
/// pieces of its faces, and a face that has changed anywhere is divided into other pieces. The size
/// controls at the parent's anchor are compared, too: a mesh that is held does not follow them.
bool same_rules(const Revision& parent, const Revision& wanted) {
  return parent.options.sizing == wanted.options.sizing &&
         parent.edge_length == wanted.edge_length &&
         parent.rules_weakening == wanted.rules_weakening &&
         parent.model.sizes == wanted.model.sizes &&
         parent.delaunay_model().sizes == wanted.model.sizes &&
         parent.dense_places == wanted.dense_places;
}

/// Tells how far from a change of the model it may be the reason for other edge lengths.
class Reach {
 public:
  Reach(const CopyPlan& plan, const Revision& parent, const Revision& wanted, double least)
      : plan_(plan),
        growth_(wanted.options.sizing.growth),
        across_(edges_asked_across(wanted.options.sizing)),
        least_(least),
        everywhere_(!same_rules(parent, wanted)) {}

  /// Whether a change may be why the length at a place is `now` and was `before`. A change asks for
  /// the least length or more, and lengths grow with the distance from it; or it is the other side
  /// of a wall, `edges_asked_across` edge lengths away.
  [[nodiscard]] bool holds(const Vec3& p, double before, double now) const {
    if (everywhere_) return true;
    const double longer = std::fmax(before, now);
    const double grown = (longer - least_) / (growth_ - 1);
    return plan_.in_changed(p, std::fmax(grown, across_ * longer));
  }

 private:
  const CopyPlan& plan_;
  double growth_, across_;
  double least_;  ///< least edge length
  bool everywhere_;
};

/// The nodes that an edit may copy.
class LocatedNodes {
 public:
  LocatedNodes(const Revision& parent, const SizeField& sizes)
      : positions_(parent.delaunay_state->positions().flat()),
        cell_(kGridCell * sizes.grid_length()) {}
  [[nodiscard]] const std::vector<Vec3>& positions() const { return positions_; }
  /// Made when it is first asked for: most edits have no use for it.
  [[nodiscard]] const NearestNode& grid() {
    if (!grid_) grid_.emplace(positions_, cell_);
    return *grid_;
  }

 private:
  std::vector<Vec3> positions_;
  double cell_;
  std::optional<NearestNode> grid_;
};

/// Nodes that were made for another edge length than is wanted where they would be copied to.
class Misfits {
 public:
  using ByTransform = std::vector<std::unordered_set<std::int32_t>>;

  Misfits(const CopyPlan& plan, const Revision& parent, const Revision& wanted,
          const SizeField& sizes, LocatedNodes& nodes, const Run& run)
      : plan_(plan),
        parent_(parent),
        sizes_(sizes),
        nodes_(nodes),
        reach_(plan, parent, wanted, sizes.least()),
        found_(std::make_shared<ByTransform>(plan.transforms().size())) {
    if (plan.identity() >= 0) find_in_place(run);
    for (const SourceFeature& source : plan.sources())
      if (source.transform != plan.identity()) find_moved(source, run);
  }

  /// By transformation.
  [[nodiscard]] std::shared_ptr<const ByTransform> nodes() const { return found_; }
  /// Where they would be copied to.
  [[nodiscard]] const std::vector<Vec3>& places() const { return places_; }
  /// The longest edge length that they were made for or that is wanted there.
  [[nodiscard]] double longest() const { return longest_; }
  /// The greatest ratio of the two.
  [[nodiscard]] double most_off() const { return most_off_; }

 private:
  [[nodiscard]] bool is_off(std::int32_t node, const Vec3& place) const {
    const double was = made_for(parent_, node), now = sizes_(place);
    return differ(was, now) && reach_.holds(place, was, now);
  }
  void add(std::int32_t node, const Vec3& place, std::int32_t transform) {
    if (!(*found_)[transform].insert(node).second) return;
    places_.push_back(place);
    const double was = made_for(parent_, node), now = sizes_(place);
    longest_ = std::max({longest_, was, now});
    most_off_ = std::max({most_off_, was / now, now / was});
  }
  /// Any node may be copied in place.
  void find_in_place(const Run& run) {
    const auto off = collect_in_blocks<std::int32_t>(
        nodes_.positions().size(), kDearBlock, run,
        [&](std::size_t begin, std::size_t end, std::vector<std::int32_t>& found) {
          for (auto n = static_cast<std::int32_t>(begin); n < static_cast<std::int32_t>(end); ++n)
            if (is_off(n, nodes_.positions()[n])) found.push_back(n);
        });
    for (const std::int32_t n : off) add(n, nodes_.positions()[n], plan_.identity());
  }
  /// With a feature go the nodes in and about its box.
  void find_moved(const SourceFeature& source, const Run& run) {
    const Box& box = plan_.original().solids()[source.original].bounds();
    const Transform& motion = plan_.transforms()[source.transform];
    const double about = kResizeLimits.around * parent_.edge_length;
    Polling poll(run);
    nodes_.grid().for_each_within(0.5 * (box.lo + box.hi), 0.5 * box.diagonal() + about,
                                  [&](std::int32_t n, double) {
                                    poll();
                                    const Vec3& at = nodes_.positions()[n];
                                    if (!box.contains(at, about)) return;
                                    if (const Vec3 place = motion.apply(at); is_off(n, place))
                                      add(n, place, source.transform);
                                  });
  }

  const CopyPlan& plan_;
  const Revision& parent_;
  const SizeField& sizes_;
  LocatedNodes& nodes_;
  Reach reach_;
  std::shared_ptr<ByTransform> found_;
  std::vector<Vec3> places_;
  double longest_ = 0, most_off_ = 1;
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
      const bool kept = known && (same_tets || output.map.original_node[n] >= 0);
      const double was = kept ? made_for(parent, output.map.original_node[n]) : 0;
      const double now = kept && same_tets ? was : sizes(positions[n]);
      // `resized` has seen to nodes that are off: one that was kept all the same suits its place.
      const auto off = [&] { return differ(was, now) && reach->holds(positions[n], was, now); };
      all[n] = kept && !same_tets && !off() ? was : now;
    }
  });
  return {std::span<const double>(all), parent.output.node_sizes};
}

std::optional<Resized> resized(const CopyPlan& plan, const Revision& parent, const Revision& wanted,
                               const SizeField& sizes, const Run& run) {
  if (wanted.options.sizing.even && parent.options.sizing.even) return {};
  if (!is_known(parent) || !plan.copies()) return {};
  const auto nodes = std::make_shared<LocatedNodes>(parent, sizes);
  const Misfits misfits(plan, parent, wanted, sizes, *nodes, run);
  if (misfits.places().empty()) return {};
  CopyPlan anew = plan.with_new_where(
      [nodes, grid = &nodes->grid(), off = misfits.nodes(), back = plan.inverses()](
          const Vec3& p, std::int32_t t) {
        return (*off)[t].contains(grid->nearest(back[t].apply(p)));
      },
      Region(misfits.places(), kResizeLimits.around * misfits.longest(), 1).boxes());
  return Resized{std::move(anew), misfits.most_off()};
}

}  // namespace remeshd
