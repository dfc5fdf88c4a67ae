#include "tests/support/changed_places.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/boundary/samples.h"
#include "engine/remesh/density.h"

namespace remeshd::test {
namespace {

constexpr double kSpacing = 0.36;  // of the points, in local lengths

/// How far beside a surface material is looked for, of the diagonal: surfaces that moved less than
/// the first lie between two points of the second pair, and so on, down to what rounding does.
constexpr std::array kBeside{1e-7, 1e-9, 1e-11};

}  // namespace

ChangedPlaces::ChangedPlaces(const Revision& base, const Revision& edited)
    : before_(base.model),
      after_(edited.model),
      diagonal_(std::max(base.cells.boundary.bounds.diagonal(),
                         edited.cells.boundary.bounds.diagonal())) {
  add_changes(base, before_);
  add_changes(edited, after_);
}

void ChangedPlaces::add_changes(const Revision& of, const Membership& own) {
  const SizeField sizes = sizes_of(of, Run{});
  const BoundaryModel& boundary = of.cells.boundary;
  SampleOptions options;
  options.face_spacing = kSpacing;
  const Samples samples = sample_boundary(boundary, own, sizes, 1, options, Run{});
  for (std::size_t k = 0; k < samples.edges_begin; ++k) {
    const Sample& sample = samples.points[k];
    const Vec3 n = outward_normal(boundary.faces[sample.support.entity], sample.position);
    const auto same_beside = [&](double far) {
      const Vec3 p = sample.position + far * diagonal_ * n;
      return before_.inside(p) == after_.inside(p);
    };
    const bool same = std::ranges::all_of(
        kBeside, [&](double far) { return same_beside(far) && same_beside(-far); });
    if (!same) places_.push_back({sample.position, kSpacing * sizes(sample.position)});
  }
}

bool ChangedPlaces::within(const Vec3& p, double reach) const {
  // What was material and is none any more has changed itself.
  if (before_.inside(p) && !after_.inside(p)) return true;
  return std::ranges::any_of(places_, [&](const Place& place) {
    const double far = reach + place.slack;
    return norm2(p - place.position) <= far * far;
  });
}

double ChangedPlaces::distance_to(const Vec3& p) const {
  if (before_.inside(p) && !after_.inside(p)) return 0;
  double least = HUGE_VAL;
  for (const Place& place : places_)
    least = std::min(least, distance(p, place.position) - place.slack);
  return std::max(0.0, least);
}

std::vector<std::uint8_t> kept_nodes(const Revision& base, const Revision& edited) {
  std::vector<std::uint8_t> result(base.output.mesh.nodes.size(), 0);
  const NodeMap& map = edited.output.map;
  for (std::size_t n = 0; n < map.node_origin.size(); ++n)
    if (map.node_origin[n] == NodeOrigin::Kept) result[map.original_node[n]] = 1;
  return result;
}

KeptShares kept_shares(const Revision& base, const Revision& edited, double lengths) {
  const CowVector<Vec3>& nodes = base.output.mesh.nodes;
  const ChangedPlaces changed(base, edited);
  const SizeField sizes = sizes_of(base, Run{});
  const auto share = [&](auto n) {
    return static_cast<double>(n) / static_cast<double>(nodes.size());
  };
  return {.kept = share(std::ranges::count(kept_nodes(base, edited), 1)),
          .far = share(std::ranges::count_if(
              nodes, [&](const Vec3& p) { return !changed.within(p, lengths * sizes(p)); }))};
}

}  // namespace remeshd::test
