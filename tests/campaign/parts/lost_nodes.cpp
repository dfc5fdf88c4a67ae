#include "tests/campaign/parts/lost_nodes.h"

#include <algorithm>
#include <cmath>

#include "engine/boundary/samples.h"
#include "engine/remesh/density.h"

namespace remeshd::campaign {
namespace {

constexpr double kSpacing = 0.36;  // of the points, in local lengths
constexpr double kBeside = 1e-7;   // of the diagonal

std::vector<std::uint8_t> kept(const Revision& base, const Revision& edited) {
  std::vector<std::uint8_t> result(base.output.mesh.nodes.size(), 0);
  const NodeMap& map = edited.output.map;
  for (std::size_t n = 0; n < map.node_origin.size(); ++n)
    if (map.node_origin[n] == NodeOrigin::Kept) result[map.original_node[n]] = 1;
  return result;
}

}  // namespace

ChangedPlaces::ChangedPlaces(const Revision& base, const Revision& edited)
    : before_(base.model),
      after_(edited.model),
      tiny_(kBeside * std::max(base.cells.boundary.bounds.diagonal(),
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
    const Vec3 n = tiny_ * outward_normal(boundary.faces[sample.support.entity], sample.position);
    const bool same = before_.inside(sample.position + n) == after_.inside(sample.position + n) &&
                      before_.inside(sample.position - n) == after_.inside(sample.position - n);
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

LostNodes lost_nodes(const Revision& base, const Revision& edited) {
  LostNodes result;
  const std::vector<std::uint8_t> stays = kept(base, edited);
  result.all = static_cast<int>(std::ranges::count(stays, 0));
  if (result.all == 0) return result;
  const ChangedPlaces changed(base, edited);
  const SizeField sizes = sizes_of(base, Run{});
  for (std::size_t n = 0; n < stays.size(); ++n) {
    const Vec3& p = base.output.mesh.nodes[n];
    const double local = sizes(p);
    if (stays[n] != 0 || changed.within(p, kFar * local)) continue;
    ++result.far;
    result.furthest = std::max(result.furthest, std::min(kNowhere, changed.distance_to(p) / local));
  }
  return result;
}

}  // namespace remeshd::campaign
