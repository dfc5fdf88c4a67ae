#include <algorithm>
#include <cmath>

#include "engine/model/solid.h"

namespace remeshd {

Membership::Membership(const FeatureModel& model) {
  solids_.reserve(model.features.size());
  for (const Feature& feature : model.features) {
    solids_.emplace_back(feature);
    natures_.push_back(feature.nature);
    all_.add(solids_.back().bounds());
    if (feature.nature == Nature::Additive) bounds_.add(solids_.back().bounds());
  }
  build_grid();
}

int Membership::last_owner(const Vec3& p) const {
  const std::span<const int> near = candidates(p);
  for (std::size_t k = near.size(); k-- > 0;)
    if (solids_[near[k]].contains(p)) return near[k];
  return -1;
}

bool Membership::inside(const Vec3& p) const {
  const int owner = last_owner(p);
  return owner >= 0 && natures_[owner] == Nature::Additive;
}

void Membership::owners(const Vec3& p, std::vector<int>& out) const {
  for (const int feature : candidates(p))
    if (solids_[feature].contains(p)) out.push_back(feature);
}

std::array<int, 3> Membership::grid_index(const Vec3& p) const {
  const Vec3 d = p - all_.lo;
  const int last = cells_per_axis_ - 1;
  return {std::clamp(static_cast<int>(d.x * cells_per_length_.x), 0, last),
          std::clamp(static_cast<int>(d.y * cells_per_length_.y), 0, last),
          std::clamp(static_cast<int>(d.z * cells_per_length_.z), 0, last)};
}

std::span<const int> Membership::candidates(const Vec3& p) const {
  if (!all_.contains(p)) return {};
  const auto [x, y, z] = grid_index(p);
  const int cell = (z * cells_per_axis_ + y) * cells_per_axis_ + x;
  return {features_.data() + first_[cell], features_.data() + first_[cell + 1]};
}

void Membership::build_grid() {
  const auto features = static_cast<double>(solids_.size());
  cells_per_axis_ = static_cast<int>(std::ceil(std::cbrt(8 * features)));
  const auto each_cell = [&](const Solid& solid, const auto& visit) {
    const auto lo = grid_index(solid.bounds().lo), hi = grid_index(solid.bounds().hi);
    for (int z = lo[2]; z <= hi[2]; ++z)
      for (int y = lo[1]; y <= hi[1]; ++y)
        for (int x = lo[0]; x <= hi[0]; ++x) visit((z * cells_per_axis_ + y) * cells_per_axis_ + x);
  };
  // Features that all reach everywhere gain nothing from a fine grid and would fill the memory.
  for (;; cells_per_axis_ = (cells_per_axis_ + 1) / 2) {
    const Vec3 size = all_.hi - all_.lo;
    const double n = cells_per_axis_;
    // Far from the origin rounding may flatten a box.
    cells_per_length_ = {size.x > 0 ? n / size.x : 0, size.y > 0 ? n / size.y : 0,
                         size.z > 0 ? n / size.z : 0};
    double entries = 0;
    for (const Solid& solid : solids_) {
      const auto lo = grid_index(solid.bounds().lo), hi = grid_index(solid.bounds().hi);
      entries += static_cast<double>(hi[0] - lo[0] + 1) * (hi[1] - lo[1] + 1) * (hi[2] - lo[2] + 1);
    }
    if (cells_per_axis_ == 1 || entries <= 64 * features + 4096) break;
  }
  const int cells = cells_per_axis_ * cells_per_axis_ * cells_per_axis_;
  first_.assign(cells + 1, 0);
  for (const Solid& solid : solids_) each_cell(solid, [&](int cell) { ++first_[cell + 1]; });
  for (int k = 0; k < cells; ++k) first_[k + 1] += first_[k];
  features_.resize(first_[cells]);
  std::vector<int> next = first_;
  for (std::size_t k = 0; k < solids_.size(); ++k)
    each_cell(solids_[k], [&](int cell) { features_[next[cell]++] = static_cast<int>(k); });
}

}  // namespace remeshd
