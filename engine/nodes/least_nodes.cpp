#include "engine/nodes/least_nodes.h"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "engine/model/solid.h"
#include "engine/nodes/density.h"

namespace remeshd {
namespace {

/// At most this many of the features that are too large by themselves are looked at: the time for
/// each is linear in the number of all features.
constexpr std::size_t kMostLookedAt = 16;

/// A feature with what is known of it in closed form.
struct Measured {
  int feature;  ///< index in history
  bool additive;
  double volume;
  std::array<double, 3> sides;  ///< of its own box, ascending
  Box box;                      ///< in the world
};

double box_volume(const Box& box) {
  const Vec3 sides = box.hi - box.lo;
  return sides.x * sides.y * sides.z;
}

/// At most the volume that two features share.
double common_volume(const Measured& a, const Measured& b) {
  const Box common = intersection(a.box, b.box);
  return common.empty() ? 0 : std::min({a.volume, b.volume, box_volume(common)});
}

std::vector<Measured> measure(const FeatureModel& model) {
  std::vector<Measured> measured;
  measured.reserve(model.features.size());
  for (const Feature& feature : model.features) {
    const Box own = local_bounds(feature.shape);
    const Vec3 extent = own.hi - own.lo;
    Measured m{static_cast<int>(measured.size()),
               feature.nature == Nature::Additive,
               volume_of(feature.shape),
               {extent.x, extent.y, extent.z},
               world_bounds(feature)};
    std::ranges::sort(m.sides);
    measured.push_back(m);
  }
  return measured;
}

/// The least extent that material of this volume has within a feature's box. Seen along the
/// thickness it covers at least an area of volume / thickness, and its boundary twice that; along
/// the longest side it is at least volume / (thickness x width) long.
Extent least_extent(const Measured& feature, double volume) {
  const auto& [thickness, width, length] = feature.sides;
  return {volume, 2 * volume / thickness, volume / (thickness * width)};
}

/// Lower bound of the volume that later subtractive features leave of an additive feature.
double volume_left(const Measured& feature, const std::vector<Measured>& all) {
  double left = feature.volume;
  for (std::size_t k = feature.feature + 1; k < all.size() && left > 0; ++k)
    if (!all[k].additive) left -= common_volume(feature, all[k]);
  return std::max(left, 0.0);
}

/// Lower bound of the volume of all material: what two additive features may share is taken off
/// once for each two, and so is what a later subtractive one may cut away. 0 once it is below
/// `wanted`.
double volume_of_all(const std::vector<Measured>& all, double wanted) {
  double volume = 0;
  Box box;
  std::vector<const Measured*> sorted;
  for (const Measured& m : all) {
    if (m.additive) volume += m.volume;
    box.add(m.box);
    sorted.push_back(&m);
  }
  // Sweep along the axis in which the features extend furthest: few of them overlap there.
  const Vec3 extent = box.hi - box.lo;
  const double longest = std::max({extent.x, extent.y, extent.z});
  const auto axis = extent.x == longest ? &Vec3::x : extent.y == longest ? &Vec3::y : &Vec3::z;
  std::ranges::sort(sorted, {}, [&](const Measured* m) { return m->box.lo.*axis; });
  for (std::size_t a = 0; a < sorted.size(); ++a)
    for (std::size_t b = a + 1; b < sorted.size(); ++b) {
      if (sorted[b]->box.lo.*axis > sorted[a]->box.hi.*axis) break;
      const bool in_order = sorted[a]->feature < sorted[b]->feature;
      const Measured& first = in_order ? *sorted[a] : *sorted[b];
      const Measured& second = in_order ? *sorted[b] : *sorted[a];
      if (!first.additive) continue;  // it cuts nothing that is added later
      volume -= common_volume(first, second);
      if (volume < wanted) return 0;
    }
  return volume;
}

}  // namespace

LeastNodes least_nodes(const FeatureModel& model, double edge_length, double limit) {
  const std::vector<Measured> all = measure(model);
  const auto nodes_of = [&](const Measured& m, double volume) {
    return nodes_needed(least_extent(m, volume), edge_length);
  };
  double sum = 0;
  std::vector<std::pair<double, const Measured*>> too_large;  // if nothing were cut away
  for (const Measured& m : all) {
    if (!m.additive) continue;
    const double nodes = nodes_of(m, m.volume);
    sum += nodes;
    if (nodes > limit) too_large.emplace_back(nodes, &m);
  }
  if (sum <= limit) return {};
  std::ranges::stable_sort(too_large, std::greater{},
                           [](const auto& entry) { return entry.first; });
  too_large.resize(std::min(too_large.size(), kMostLookedAt));
  for (const auto& [whole, m] : too_large)
    if (const double nodes = nodes_of(*m, volume_left(*m, all)); nodes > limit)
      return {nodes, model.features[m->feature].id};
  // Of all features together only the volume is bounded: their boundaries may coincide.
  const double per_volume = nodes_needed({1, 0, 0}, edge_length);
  const double volume = volume_of_all(all, limit / per_volume);
  return {volume * per_volume, {}};
}

}  // namespace remeshd
