#include "engine/local_fuse/arrangement/sectors.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "engine/base/angle.h"
#include "engine/base/tolerance.h"

namespace remeshd {
namespace {

struct SectorLimits {
  double near = 10;           ///< steps: a face that is nearer must contain the curve
  double same_angle = 1e-7;   ///< rad
  double clear_angle = 0.02;  ///< rad: between half-faces
};
constexpr SectorLimits kSectorLimits;

/// Whether two patches lie on one surface.
///
/// Pre: p is on both, and their normals there are parallel.
bool same_patch_surface(const Patch& a, const Patch& b, const Vec3& p, double same) {
  if (a.round != b.round) return false;
  if (!a.round) return true;
  return std::fabs(a.radius - b.radius) <= same && dot(a.normal_at(p), b.normal_at(p)) > 0 &&
         norm(cross(a.axis(), b.axis())) <= tolerance::kSameDirection;
}

}  // namespace

Sectors::Sectors(const Membership& membership, std::span<const int> features,
                 const Patches& patches, double diagonal, const Clearance& clearance)
    : membership_(membership),
      features_(features),
      patches_(patches),
      clearance_(clearance),
      step_(tolerance::kWideProbe * diagonal) {
  for (const int f : features)
    boxes_.push_back(grown(membership.solids()[f].bounds(), kSectorLimits.near * step_));
}

bool Sectors::material(FeatureSet owners) const {
  return owners != 0 &&
         membership_.nature(features_[std::bit_width(owners) - 1]) == Nature::Additive;
}

FeatureSet Sectors::owners(const Vec3& p, FeatureSet candidates) const {
  FeatureSet out = 0;
  for (FeatureSet left = candidates; left != 0; left &= left - 1) {
    const int k = std::countr_zero(left);
    if (membership_.contains(features_[k], p)) out |= FeatureSet{1} << k;
  }
  return out;
}

/// Adds the patches that a half-face consists of: one of each feature that lies either before or
/// behind it, not both.
Tried<void> Sectors::add_covers(HalfFace& half_face, const Vec3& p,
                                const std::vector<const Patch*>& through) const {
  const Vec3 on = p + step_ * half_face.direction;
  for (FeatureSet left = half_face.before ^ half_face.behind; left != 0; left &= left - 1) {
    const int feature = features_[std::countr_zero(left)];
    const Patch* cover = nullptr;
    for (const Patch* patch : through) {
      if (patch->feature != feature || !patch->beside(on, 0.5 * step_)) continue;
      if (std::fabs(dot(half_face.direction, patch->normal_at(p))) > kSectorLimits.same_angle)
        continue;
      if (cover != nullptr)
        return GaveUp{"sectors", "two faces of one feature cover the same half-face"};
      cover = patch;
    }
    if (cover == nullptr)
      return GaveUp{"sectors", "no face of a feature covers a half-face that bounds it"};
    if (!half_face.covers.empty() &&
        !same_patch_surface(*half_face.covers.front(), *cover, p, clearance_.same))
      return GaveUp{"sectors", "the faces that cover a half-face are not on the same surface"};
    half_face.covers.push_back(cover);
  }
  return {};
}

Tried<std::vector<HalfFace>> Sectors::around(const IntersectionCurve& curve, double t) const {
  const auto [p, derivative] = curve.at(t);
  const Vec3 along = normalised(derivative);
  Vec3 u = curve.round ? std::cos(t) * curve.x + std::sin(t) * curve.y : any_perpendicular(along);
  u = normalised(u - dot(u, along) * along);
  const Vec3 v = cross(along, u);

  std::vector<const Patch*> through;
  std::vector<double> angles;
  for (const Patch& patch : patches_.patches) {
    if (!patch.box.contains(p, kSectorLimits.near * step_)) continue;
    const double d = std::fabs(patch.distance_to(p));
    if (d > kSectorLimits.near * step_) continue;
    const Vec3 n = patch.normal_at(p);
    if (d > clearance_.same)
      return GaveUp{"sectors", "a face comes near a curve that it does not clearly contain"};
    if (std::fabs(dot(n, along)) > tolerance::kSameDirection)
      return GaveUp{"sectors", "a face crosses a curve where no edge ends"};
    const Vec3 side = cross(n, along);
    const double angle = std::atan2(dot(side, v), dot(side, u));
    through.push_back(&patch);
    for (const double turn : {0.0, std::numbers::pi}) {
      const double a = std::fmod(angle + turn + kTurn, kTurn);
      angles.push_back(a > kTurn - kSectorLimits.same_angle ? 0 : a);
    }
  }
  std::ranges::sort(angles);
  std::vector<double> apart;
  for (const double a : angles)
    if (apart.empty() || a - apart.back() > kSectorLimits.same_angle) apart.push_back(a);
  if (apart.size() < 2) return std::vector<HalfFace>{};

  FeatureSet candidates = 0;
  for (std::size_t k = 0; k < boxes_.size(); ++k)
    if (boxes_[k].contains(p)) candidates |= FeatureSet{1} << k;
  const auto towards = [&](double a) { return std::cos(a) * u + std::sin(a) * v; };
  std::vector<FeatureSet> between;  // by angle: the owners between it and the next
  for (std::size_t i = 0; i < apart.size(); ++i) {
    const double next = i + 1 < apart.size() ? apart[i + 1] : apart.front() + kTurn;
    if (next - apart[i] < kSectorLimits.clear_angle)
      return GaveUp{"sectors", "two faces meet at a curve at a very small angle"};
    between.push_back(owners(p + step_ * towards(0.5 * (apart[i] + next)), candidates));
  }
  std::vector<HalfFace> half_faces;
  for (std::size_t i = 0; i < apart.size(); ++i) {
    const FeatureSet before = between[(i + apart.size() - 1) % apart.size()];
    if (before == between[i]) continue;
    HalfFace& half_face = half_faces.emplace_back();
    half_face.direction = towards(apart[i]);
    half_face.ahead = cross(along, half_face.direction);
    half_face.before = before;
    half_face.behind = between[i];
    if (const auto covered = add_covers(half_face, p, through); !covered) return covered.why();
  }
  return half_faces;
}

}  // namespace remeshd
