#include "engine/optimise/active_samples.h"

#include <numeric>

#include "engine/base/parallel.h"
#include "engine/base/region.h"

namespace remeshd {

namespace {
constexpr double kBorder = 0.6;  // x edge length: reaches the next one or two samples on a face
constexpr double kReach = 1.5;   // x edge length: no sample is further from its nearest node

}  // namespace

ActiveSamples::ActiveSamples(const Samples& samples)
    : states_(samples.points.size(), State::Active),
      participants_(samples.points.size()),
      active_count_(static_cast<std::uint32_t>(samples.points.size())) {
  std::iota(participants_.begin(), participants_.end(), 0U);
}

ActiveSamples::ActiveSamples(const NodeSet& nodes, const SizeField& sizes, NearestToPoints& nearest,
                             const Run& run)
    : sizes_(sizes), states_(nearest.points().size(), State::Resting), nearest_(&nearest) {
  refresh(nodes, run);
}

void ActiveSamples::refresh(const NodeSet& nodes, const Run& run) {
  if (!nearest_) return;
  // Samples far from every free node cannot have one nearest.
  std::vector<Vec3> free;
  for (std::int32_t n = 0; n < nodes.size(); ++n)
    if (nodes.is_free(n)) free.push_back(nodes.positions[n]);
  const Region near_free(free, kReach * sizes_.base(), 1);
  nearest_->follow(nodes.positions);
  const auto near = collect_in_blocks<std::uint32_t>(
      states_.size(), kCheapBlock, run,
      [&](std::size_t begin, std::size_t end, std::vector<std::uint32_t>& found) {
        for (auto s = static_cast<std::uint32_t>(begin); s < end; ++s)
          if (states_[s] != State::Active && near_free.holds(nearest_->points()[s]))
            found.push_back(s);
      });
  const std::vector<std::int32_t> node = nearest_->nearest(near, run);
  for (std::size_t k = 0; k < near.size(); ++k)
    if (node[k] >= 0 && nodes.is_free(node[k])) activate(near[k]);
  collect();
}

void ActiveSamples::promote(std::span<const std::uint32_t> pulling) {
  if (!nearest_) return;
  bool changed = false;
  for (const std::uint32_t s : pulling) {
    if (states_[s] == State::Active) continue;
    activate(s);
    changed = true;
  }
  if (changed) collect();
}

void ActiveSamples::activate(std::uint32_t sample) {
  states_[sample] = State::Active;
  const Vec3& at = nearest_->points()[sample];
  nearest_->grid_of_points().for_each_within(at, kBorder * sizes_(at),
                                             [&](std::int32_t other, double) {
                                               if (states_[other] == State::Resting)
                                                 states_[other] = State::Border;
                                             });
}

void ActiveSamples::collect() {
  participants_.clear();
  active_count_ = 0;
  for (std::uint32_t s = 0; s < states_.size(); ++s) {
    if (states_[s] != State::Resting) participants_.push_back(s);
    if (states_[s] == State::Active) ++active_count_;
  }
}

}  // namespace remeshd
