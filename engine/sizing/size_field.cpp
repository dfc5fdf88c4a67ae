#include "engine/sizing/size_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace remeshd {

namespace {

struct TreeLimits {
  std::size_t few = 4;   ///< sources that are asked one by one
  int deepest = 6;       ///< levels
  double margin = 0.05;  ///< x diagonal of the bounds: beyond them
};
constexpr TreeLimits kLimits;

struct PartLimits {
  double even = 1.2;   ///< the greatest edge length of a part over the least
  double least = 1.5;  ///< x edge length: a part that small is not divided
};
constexpr PartLimits kParts;

double distance_to(const Box& box, const Vec3& p) {
  const Vec3 d{std::max({box.lo.x - p.x, p.x - box.hi.x, 0.0}),
               std::max({box.lo.y - p.y, p.y - box.hi.y, 0.0}),
               std::max({box.lo.z - p.z, p.z - box.hi.z, 0.0})};
  return norm(d);
}

Vec3 middle_of(const Box& box) { return 0.5 * (box.lo + box.hi); }

}  // namespace

double SizeSource::at(const Vec3& p, const SizeLimits& limits, double enough) const {
  const bool cone = surface.kind == Surface::Kind::Cone;
  const double to_box = distance_to(box, p);
  const double bound = std::fmax(cone ? 0 : size, limits.least) + limits.slope * to_box;
  if (bound >= enough) return bound;
  const double wanted = cone ? size * radius_of_curvature(surface, project(surface, p)) : size;
  return std::fmax(wanted, limits.least) +
         limits.slope * std::fmax(std::fabs(signed_distance(surface, p)), to_box);
}

/// Cubes of space, each with the sources that may be the least in it.
class SizeField::Tree {
 public:
  Tree(const SizeLimits& limits, std::vector<SizeSource> sources, const Box& bounds)
      : limits_(limits), sources_(std::move(sources)) {
    const bool cones = std::ranges::any_of(
        sources_, [](const SizeSource& s) { return s.surface.kind == Surface::Kind::Cone; });
    steepest_ = (cones ? 2 : 1) * limits.slope;
    const Vec3 middle = middle_of(bounds);
    const double half = (0.5 + kLimits.margin) * bounds.diagonal();
    box_ = {middle - Vec3{half, half, half}, middle + Vec3{half, half, half}};
    std::vector<std::int32_t> all(sources_.size());
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<std::int32_t>(k);
    cells_.emplace_back();
    fill(0, middle, half, all, 0);
  }

  /// How steep the field may be, on cones and beside them.
  [[nodiscard]] double steepest() const { return steepest_; }
  /// The least that sources ask for.
  [[nodiscard]] double operator()(const Vec3& p) const {
    if (!box_.contains(p)) return least_of(p, all_of(sources_.size()));
    const Cell* cell = cells_.data();
    Vec3 middle = middle_of(box_);
    double half = 0.5 * (box_.hi.x - box_.lo.x);
    while (cell->children >= 0) {
      const int octant =
          (p.x > middle.x ? 1 : 0) + (p.y > middle.y ? 2 : 0) + (p.z > middle.z ? 4 : 0);
      half *= 0.5;
      middle += half * direction(octant);
      cell = &cells_[cell->children + octant];
    }
    return least_of(p, std::span(listed_).subspan(cell->begin, cell->count));
  }

 private:
  struct Cell {
    std::int32_t children = -1;  ///< the first of eight
    std::uint32_t begin = 0, count = 0;
  };

  static Vec3 direction(int octant) {
    return {octant & 1 ? 1.0 : -1.0, octant & 2 ? 1.0 : -1.0, octant & 4 ? 1.0 : -1.0};
  }
  static std::vector<std::int32_t> all_of(std::size_t count) {
    std::vector<std::int32_t> all(count);
    for (std::size_t k = 0; k < count; ++k) all[k] = static_cast<std::int32_t>(k);
    return all;
  }

  [[nodiscard]] double least_of(const Vec3& p, std::span<const std::int32_t> sources) const {
    double least = HUGE_VAL;
    for (const std::int32_t s : sources)
      least = std::fmin(least, sources_[s].at(p, limits_, least));
    return least;
  }

  void fill(std::int32_t cell, const Vec3& middle, double half,
            std::span<const std::int32_t> candidates, int level) {
    const double reach = std::sqrt(3.0) * half;
    std::vector<double> at_middle;
    double most = HUGE_VAL;  // that the field may be anywhere in the cell
    for (const std::int32_t s : candidates) {
      at_middle.push_back(sources_[s].at(middle, limits_, most + steepest_ * reach));
      most = std::fmin(most, at_middle.back() + steepest_ * reach);
    }
    std::vector<std::int32_t> near;
    bool matters = false;
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      if (at_middle[k] - steepest_ * reach > most) continue;
      near.push_back(candidates[k]);
      matters |= at_middle[k] - steepest_ * reach < limits_.base;
    }
    if (near.size() <= kLimits.few || !matters || level == kLimits.deepest) {
      cells_[cell].begin = static_cast<std::uint32_t>(listed_.size());
      cells_[cell].count = static_cast<std::uint32_t>(near.size());
      listed_.insert(listed_.end(), near.begin(), near.end());
      return;
    }
    const auto first = static_cast<std::int32_t>(cells_.size());
    cells_[cell].children = first;
    cells_.resize(cells_.size() + 8);
    for (int octant = 0; octant < 8; ++octant)
      fill(first + octant, middle + 0.5 * half * direction(octant), 0.5 * half, near, level + 1);
  }

  SizeLimits limits_;
  std::vector<SizeSource> sources_;
  double steepest_ = 0;
  Box box_;
  std::vector<Cell> cells_;
  std::vector<std::int32_t> listed_;  ///< sources, cell by cell
};

SizeField::SizeField(double base) : limits_{base, base, 0} {}

SizeField::SizeField(const SizeLimits& limits, std::vector<SizeSource> sources, const Box& bounds)
    : limits_(limits) {
  std::erase_if(sources, [&](const SizeSource& s) {
    return s.surface.kind != Surface::Kind::Cone && s.size >= limits.base;
  });
  double least = limits.base;
  for (const SizeSource& s : sources)
    least = std::fmin(least, s.surface.kind == Surface::Kind::Cone ? limits.least : s.size);
  limits_.least = std::fmax(least, std::fmin(limits.least, limits.base));
  if (!sources.empty()) tree_ = std::make_shared<const Tree>(limits_, std::move(sources), bounds);
}

double SizeField::asked_for(const Vec3& p) const { return even() ? HUGE_VAL : (*tree_)(p); }

double SizeField::operator()(const Vec3& p) const { return std::fmin(limits_.base, asked_for(p)); }

double SizeField::grid_length() const { return std::sqrt(limits_.base * limits_.least); }

SizeField::Range SizeField::in(const Box& box) const {
  if (even()) return {limits_.base, limits_.base};
  const double middle = asked_for(middle_of(box));
  const double reach = tree_->steepest() * 0.5 * box.diagonal();
  return {std::clamp(middle - reach, limits_.least, limits_.base),
          std::clamp(middle + reach, limits_.least, limits_.base)};
}

bool SizeField::EvenPart::holds(const Vec3& p) const {
  const auto along = [&](double Vec3::*axis) {
    const double v = std::clamp(p.*axis, whole.lo.*axis, whole.hi.*axis);
    return v >= box.lo.*axis && (v < box.hi.*axis || box.hi.*axis == whole.hi.*axis);
  };
  return along(&Vec3::x) && along(&Vec3::y) && along(&Vec3::z);
}

std::vector<SizeField::EvenPart> SizeField::even_parts(const Box& box) const {
  std::vector<EvenPart> parts;
  divide(box, box, parts);
  return parts;
}

void SizeField::divide(const Box& box, const Box& whole, std::vector<EvenPart>& parts) const {
  const Range range = in(box);
  const double length = (*this)(middle_of(box));
  const Vec3 sides = box.hi - box.lo;
  const double longest = std::max({sides.x, sides.y, sides.z});
  if (range.greatest <= kParts.even * range.least || longest <= kParts.least * length) {
    parts.push_back({box, whole, length});
    return;
  }
  const auto axis = sides.x == longest ? &Vec3::x : sides.y == longest ? &Vec3::y : &Vec3::z;
  Box low = box, high = box;
  low.hi.*axis = high.lo.*axis = 0.5 * (box.lo.*axis + box.hi.*axis);
  divide(low, whole, parts);
  divide(high, whole, parts);
}

}  // namespace remeshd
