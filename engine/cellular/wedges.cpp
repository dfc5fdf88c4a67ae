#include "engine/cellular/wedges.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "engine/cellular/changes.h"

namespace remeshd {
namespace {

constexpr double kStep = 1e-7;        // of the diagonal
constexpr double kNear = 10;          // steps: nothing else may be nearer
constexpr double kSameAngle = 1e-7;   // rad
constexpr double kClearAngle = 0.02;  // rad: between sheets
constexpr double kThrough = 1e-9;     // sine of the angle between a curve and a patch it lies on

/// Of patches with the same normal at a point of both.
bool same_patch_surface(const Patch& a, const Patch& b, const Vec3& p, double same) {
  if (a.round != b.round) return false;
  if (!a.round) return true;
  return std::fabs(a.radius - b.radius) <= same && dot(a.normal_at(p), b.normal_at(p)) > 0 &&
         norm(cross(a.axis(), b.axis())) <= kThrough;
}

}  // namespace

Wedges::Wedges(const Membership& membership, std::span<const int> features, const Patches& patches,
               double diagonal, const Clearance& clearance)
    : membership_(membership),
      features_(features),
      patches_(patches),
      clearance_(clearance),
      step_(kStep * diagonal) {
  for (const int f : features)
    boxes_.push_back(grown(membership.solids()[f].bounds(), kNear * step_));
}

bool Wedges::material(FeatureSet owners) const {
  return owners != 0 &&
         membership_.nature(features_[std::bit_width(owners) - 1]) == Nature::Additive;
}

FeatureSet Wedges::owners(const Vec3& p, FeatureSet candidates) const {
  FeatureSet out = 0;
  for (FeatureSet left = candidates; left != 0; left &= left - 1) {
    const int k = std::countr_zero(left);
    if (membership_.contains(features_[k], p)) out |= FeatureSet{1} << k;
  }
  return out;
}

/// The patches that part what lies before a sheet from what lies behind it, one of each feature.
bool Wedges::add_covers(Sheet& sheet, const Vec3& p,
                        const std::vector<const Patch*>& through) const {
  const Vec3 on = p + step_ * sheet.direction;
  for (FeatureSet left = sheet.before ^ sheet.behind; left != 0; left &= left - 1) {
    const int feature = features_[std::countr_zero(left)];
    const Patch* cover = nullptr;
    for (const Patch* patch : through) {
      if (patch->feature != feature || !patch->beside(on, 0.5 * step_)) continue;
      if (std::fabs(dot(sheet.direction, patch->normal_at(p))) > kSameAngle) continue;
      if (cover != nullptr) return false;
      cover = patch;
    }
    if (cover == nullptr) return false;
    if (!sheet.covers.empty() &&
        !same_patch_surface(*sheet.covers.front(), *cover, p, clearance_.same))
      return false;
    sheet.covers.push_back(cover);
  }
  return true;
}

std::optional<std::vector<Sheet>> Wedges::around(const Carrier& carrier, double t) const {
  const auto [p, derivative] = carrier.at(t);
  const Vec3 along = normalised(derivative);
  Vec3 u =
      carrier.round ? std::cos(t) * carrier.x + std::sin(t) * carrier.y : any_perpendicular(along);
  u = normalised(u - dot(u, along) * along);
  const Vec3 v = cross(along, u);

  std::vector<const Patch*> through;
  std::vector<double> angles;
  for (const Patch& patch : patches_.patches) {
    if (!patch.box.contains(p, kNear * step_)) continue;
    const double d = std::fabs(patch.distance_to(p));
    if (d > kNear * step_) continue;
    const Vec3 n = patch.normal_at(p);
    if (d > clearance_.same || std::fabs(dot(n, along)) > kThrough) return std::nullopt;
    const Vec3 side = cross(n, along);
    const double angle = std::atan2(dot(side, v), dot(side, u));
    through.push_back(&patch);
    for (const double turn : {0.0, std::numbers::pi}) {
      const double a = std::fmod(angle + turn + 2 * std::numbers::pi, 2 * std::numbers::pi);
      angles.push_back(a > 2 * std::numbers::pi - kSameAngle ? 0 : a);
    }
  }
  std::ranges::sort(angles);
  std::vector<double> apart;
  for (const double a : angles)
    if (apart.empty() || a - apart.back() > kSameAngle) apart.push_back(a);
  if (apart.size() < 2) return std::vector<Sheet>{};

  FeatureSet candidates = 0;
  for (std::size_t k = 0; k < boxes_.size(); ++k)
    if (boxes_[k].contains(p)) candidates |= FeatureSet{1} << k;
  const auto towards = [&](double a) { return std::cos(a) * u + std::sin(a) * v; };
  std::vector<FeatureSet> between;  // an angle and the next
  for (std::size_t i = 0; i < apart.size(); ++i) {
    const double next = i + 1 < apart.size() ? apart[i + 1] : apart.front() + 2 * std::numbers::pi;
    if (next - apart[i] < kClearAngle) return std::nullopt;
    between.push_back(owners(p + step_ * towards(0.5 * (apart[i] + next)), candidates));
  }
  std::vector<Sheet> sheets;
  for (std::size_t i = 0; i < apart.size(); ++i) {
    const FeatureSet before = between[(i + apart.size() - 1) % apart.size()];
    if (before == between[i]) continue;
    Sheet& sheet = sheets.emplace_back();
    sheet.direction = towards(apart[i]);
    sheet.ahead = cross(along, sheet.direction);
    sheet.before = before;
    sheet.behind = between[i];
    if (!add_covers(sheet, p, through)) return std::nullopt;
  }
  return sheets;
}

}  // namespace remeshd
