#include "engine/improve/smooth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/mesh/quality.h"

namespace remeshd {
namespace {

/// Lengths x the mean edge length at the node.
struct SmoothingLimits {
  int steps = 8;              ///< of one node
  int halvings = 5;           ///< of a step that does not help
  int walks = 12;             ///< of Gilbert's algorithm
  double band = 0.06;         ///< tets this close to the worst take part in choosing a direction
  double step = 0.3;          ///< length, at most
  double descent_step = 0.1;  ///< the same of an energy descent step, which is repeated
  double difference = 1e-6;   ///< step of finite differences of a score's energy
  /// Least `Score::energy` at a node for which a step is tried: what one goal that is just met
  /// adds. With a tenth of it clean-up took half as long again and helped no more.
  double energy = 1;
};
constexpr SmoothingLimits kSmoothingLimits;

}  // namespace

void Smoother::gather(std::int32_t node) {
  star_.clear();
  double sum = 0;
  const Vec3& p = mesh_.node(node);
  for (const std::int32_t t : mesh_.tets_of(node)) {
    const Tet& tet = mesh_.tet(t);
    int i = 0;
    while (tet[i] != node) ++i;
    const auto& facet = kTetFacets[i];
    star_.push_back(
        {mesh_.node(tet[facet[0]]), mesh_.node(tet[facet[1]]), mesh_.node(tet[facet[2]])});
    sum += distance(p, star_.back().b) + distance(p, star_.back().c) + distance(p, star_.back().d);
  }
  length_ = sum / static_cast<double>(3 * star_.size());
}

double Smoother::worst(const Vec3& p, double floor) const {
  double q = 1;
  for (const Opposite& o : star_) {
    q = std::min(q, volume_length(p, o.b, o.c, o.d));
    if (q <= floor) break;
  }
  return q;
}

double Smoother::slopes(const Vec3& p) {
  slopes_.clear();
  double lowest = 1;
  for (const auto& [b, c, d] : star_) {
    const Vec3 pb = b - p;
    const Vec3 pc = c - p;
    const Vec3 pd = d - p;
    const Vec3 cb = b - c;
    const Vec3 cd = d - c;
    const double mean_square =
        (norm2(pb) + norm2(pc) + norm2(pd) + norm2(cb) + norm2(cd) + norm2(d - b)) / 6.0;
    const double six_volumes = dot(cross(pb, pc), pd);
    const double scale = std::numbers::sqrt2 / (mean_square * std::sqrt(mean_square));
    // d(mean square) = -(pb + pc + pd) / 3; d(six volumes) = the inward normal of the far facet.
    const Vec3 grow = cross(cb, cd);
    const Vec3 gradient = scale * (grow + (0.5 * six_volumes / mean_square) * (pb + pc + pd));
    slopes_.push_back({scale * six_volumes, gradient});
    lowest = std::min(lowest, slopes_.back().quality);
  }
  return lowest;
}

Vec3 Smoother::ascent(double worst, double band) const {
  // Gilbert's algorithm: walk from the present point of the hull towards its corner that lies
  // farthest back.
  Vec3 v;
  bool first = true;
  for (const Slope& s : slopes_) {
    if (s.quality > worst) continue;
    v = s.gradient;
    first = false;
    break;
  }
  if (first) return v;
  for (int walk = 0; walk < kSmoothingLimits.walks; ++walk) {
    const Slope* back = nullptr;
    double least = norm2(v) * (1 - 1e-3);
    for (const Slope& s : slopes_) {
      if (s.quality > worst + band) continue;
      const double along = dot(v, s.gradient);
      if (along < least) {
        least = along;
        back = &s;
      }
    }
    if (back == nullptr) break;
    const Vec3 towards = back->gradient - v;
    const double t = std::clamp(-dot(v, towards) / norm2(towards), 0.0, 1.0);
    v += t * towards;
  }
  return v;
}

bool Smoother::slide(std::int32_t node, const Vec3& p, Vec3& direction) const {
  const double probe = 1e-3 * length_;
  const Vec3 slid = rules_.settle(node, p + (probe / norm(direction)) * direction) - p;
  const double kept = norm(slid);
  if (!(kept > 1e-3 * probe)) return false;
  const double along = dot(direction, slid) / kept;
  direction = (along / kept) * slid;
  return along > 0;
}

double Smoother::energy(const Vec3& p, double limit) const {
  double sum = 0;
  for (const Opposite& o : star_) {
    const double q = volume_length(p, o.b, o.c, o.d);
    if (!(q > kNearlyFlat)) return HUGE_VAL;
    const double q4 = q * q * q * q;
    sum += 1 / (q4 * q4);
    if (sum >= limit) break;
  }
  return sum;
}

bool Smoother::energy_descent_step(std::int32_t node, std::span<const Triangle> facets,
                                   Vec3& position) {
  gather(node);
  if (!(slopes(mesh_.node(node)) > kNearlyFlat)) return false;
  Vec3 direction;
  for (const Slope& s : slopes_) direction += std::pow(s.quality, -9) * s.gradient;
  const auto by_measure = [&](const Vec3& x, double limit) { return energy(x, limit); };
  return step_down(node, facets, direction, energy(mesh_.node(node), HUGE_VAL), by_measure,
                   position);
}

bool Smoother::energy_descent_step(std::int32_t node, const Score& score, int steepness,
                                   Vec3& position) {
  if (!rules_.facets_at(node, facets_)) return false;
  gather(node);
  const auto energy = [&](const Vec3& p, double limit) {
    double sum = 0;
    for (const Opposite& o : star_) {
      sum += score.energy(p, o.b, o.c, o.d, steepness);
      if (sum >= limit) break;
    }
    return sum;
  };
  const Vec3& p = mesh_.node(node);
  const double now = energy(p, HUGE_VAL);
  if (now < kSmoothingLimits.energy) return false;
  const double h = kSmoothingLimits.difference * length_;
  const auto fall = [&](const Vec3& by) { return now - energy(p + by, HUGE_VAL); };
  const Vec3 direction{fall({h, 0, 0}), fall({0, h, 0}), fall({0, 0, h})};
  return std::isfinite(norm2(direction)) &&
         step_down(node, facets_, direction, now, energy, position);
}

template <class Energy>
bool Smoother::step_down(std::int32_t node, std::span<const Triangle> facets, Vec3 direction,
                         double now, const Energy& energy, Vec3& position) const {
  const Vec3& p = mesh_.node(node);
  const bool slides = !rules_.interior(node);
  if (!(norm2(direction) > 0) || (slides && !slide(node, p, direction))) return false;
  const Vec3 unit = normalised(direction);
  double reach = kSmoothingLimits.descent_step * length_;
  for (int halving = 0; halving < kSmoothingLimits.halvings; ++halving, reach *= 0.5) {
    const Vec3 candidate = slides ? rules_.settle(node, p + reach * unit) : p + reach * unit;
    if (!(energy(candidate, now) < now)) continue;
    if (slides && !rules_.may_move(node, candidate, facets)) continue;
    position = candidate;
    return true;
  }
  return false;
}

bool Smoother::smooth(std::int32_t node, double enough, double gain, Vec3& position) {
  if (!rules_.facets_at(node, facets_)) return false;
  gather(node);
  const bool slides = !rules_.interior(node);
  const Vec3 start = mesh_.node(node);
  Vec3 p = start;
  double q = slopes(p);
  const double q_start = q;
  for (int step = 0; step < kSmoothingLimits.steps && q < enough; ++step) {
    if (step > 0) q = slopes(p);
    Vec3 direction = ascent(q, kSmoothingLimits.band);
    double steepness = norm(direction);
    if (steepness * length_ < 1e-3) break;
    if (slides) {
      if (!slide(node, p, direction)) break;
      steepness = norm(direction);
      if (steepness * length_ < 1e-3) break;
    }
    const Vec3 unit = direction / steepness;
    // First-order guess of where another tet becomes the worst.
    double reach = kSmoothingLimits.step * length_;
    const double rise = [&] {
      double least = steepness;
      for (const Slope& s : slopes_)
        if (s.quality <= q + 1e-12) least = std::min(least, dot(unit, s.gradient));
      return std::max(least, 0.1 * steepness);
    }();
    for (const Slope& s : slopes_) {
      const double fall = rise - dot(unit, s.gradient);
      if (fall > 1e-12 * rise && s.quality > q) reach = std::min(reach, (s.quality - q) / fall);
    }
    reach = std::max(reach, 0.01 * length_);
    bool moved = false;
    for (int halving = 0; halving < kSmoothingLimits.halvings; ++halving, reach *= 0.5) {
      const Vec3 candidate = slides ? rules_.settle(node, p + reach * unit) : p + reach * unit;
      const double reached = worst(candidate, q);
      if (reached <= q) continue;
      if (slides && !rules_.may_move(node, candidate, facets_)) continue;
      p = candidate;
      moved = reached > q + 0.1 * gain;
      q = reached;
      break;
    }
    if (!moved) break;
  }
  position = p;
  return q >= q_start + gain;
}

}  // namespace remeshd
