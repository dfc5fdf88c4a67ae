#include "engine/plan/copy_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "engine/base/tolerance.h"

namespace remeshd {

namespace {

struct PlanLimits {
  double step = 1.0;       ///< of the measuring lattice, x the edge length
  double points = 20000;   ///< of that lattice, at most; the order of sources needs no more
  double of_extent = 0.1;  ///< x a feature's least extent: less is a motion in place
};
constexpr PlanLimits kPlanLimits;

/// The rigid motion that carries the frame `from` to `to`; a pure translation where the axes agree.
Transform motion(const Transform& from, const Transform& to) {
  bool turned = false;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) turned |= from.m[4 * r + c] != to.m[4 * r + c];
  if (turned) return to * rigid_inverse(from);
  return Transform::translation({to.m[3] - from.m[3], to.m[7] - from.m[7], to.m[11] - from.m[11]});
}

bool same_motion(const Transform& a, const Transform& b, double size) {
  for (int k = 0; k < 12; ++k) {
    const double most = k % 4 == 3 ? tolerance::kRounding * size : tolerance::kRounding;
    if (std::fabs(a.m[k] - b.m[k]) > most) return false;
  }
  return true;
}

/// Whether two features have the same geometry in their aligned frames.
bool same_shape(const Feature& a, const Feature& b) {
  FeatureModel ma{"", {a}}, mb{"", {b}};
  mb.features[0].placement = a.placement;
  mb.features[0].alignment = a.alignment;
  mb.features[0].reference = a.reference;
  return same_geometry(ma, mb);
}

double volume_of(const Box& box) {
  const Vec3 extent = box.hi - box.lo;
  return extent.x * extent.y * extent.z;
}

}  // namespace

CopyPlan::CopyPlan(const FeatureModel& original, const FeatureModel& modified,
                   const CopyLengths& lengths, const Run& run)
    : modified_(modified),
      original_(original),
      probe_(tolerance::kProbe * modified_.bounds().diagonal()) {
  if (!copies()) {
    changed_.push_back(modified_.bounds());
    return;
  }
  match(original, modified, lengths.in_place);
  measure(lengths.edge_length, run);
}

std::int32_t CopyPlan::find_transform(const Feature& original, const Feature& modified) {
  const double size = modified_.bounds().diagonal();
  Transform m = motion(original.alignment, modified.alignment);
  if (same_motion(m, Transform{}, size)) m = {};
  for (std::size_t k = 0; k < transforms_.size(); ++k)
    if (same_motion(m, transforms_[k], size)) return static_cast<std::int32_t>(k);
  transforms_.push_back(m);
  inverses_.push_back(m.is_identity() ? Transform{}
                                      : motion(modified.alignment, original.alignment));
  if (m.is_identity()) identity_ = static_cast<std::int32_t>(transforms_.size()) - 1;
  return static_cast<std::int32_t>(transforms_.size()) - 1;
}

bool CopyPlan::moves_less(int original, const Transform& motion, double in_place) const {
  const Box& box = original_.solids()[original].bounds();
  const Vec3 extent = box.hi - box.lo;
  const double least = std::fmin(extent.x, std::fmin(extent.y, extent.z));
  const double most = std::fmin(in_place, kPlanLimits.of_extent * least);
  return std::ranges::all_of(corners_of(box), [&](const Vec3& corner) {
    return distance(corner, motion.apply(corner)) < most;
  });
}

void CopyPlan::match(const FeatureModel& original, const FeatureModel& modified, double in_place) {
  const double size = modified_.bounds().diagonal();
  std::vector<std::uint8_t> matched(original.features.size(), 0);
  int last = -1;
  for (int m = 0; m < static_cast<int>(modified.features.size()); ++m) {
    const Feature& now = modified.features[m];
    const int o = original.index_of(now.id);
    const Box& box = modified_.solids()[m].bounds();
    if (o < 0) {
      changed_.push_back(box);
      continue;
    }
    matched[o] = 1;
    const Feature& then = original.features[o];
    const Transform moved = motion(then.alignment, now.alignment);
    const bool stays = !same_motion(moved, {}, size) && moves_less(o, moved, in_place);
    const std::int32_t transform = find_transform(then, stays ? then : now);
    const bool same = !stays && same_shape(then, now);
    sources_.push_back({o, m, transform, inverses_[transform], same, 0});
    const bool in_order = o > last;
    last = std::max(last, o);
    if (transform == identity_ && in_order && then.nature == now.nature && same) continue;
    changed_.push_back(box);
    changed_.push_back(original_.solids()[o].bounds());
  }
  for (std::size_t o = 0; o < matched.size(); ++o)
    if (!matched[o]) changed_.push_back(original_.solids()[o].bounds());
  for (Box& box : changed_) box = grown(box, 10 * probe_);  // rounding at its sides must not decide
}

void CopyPlan::measure(double edge_length, const Run& run) {
  const Box& box = modified_.bounds();
  const Vec3 extent = box.hi - box.lo;
  const double h = std::fmax(kPlanLimits.step * edge_length,
                             std::cbrt(extent.x * extent.y * extent.z / kPlanLimits.points));
  const auto steps = [h](double v) { return static_cast<int>(std::ceil(v / h)); };
  for (int k = 0; k < steps(extent.z); ++k) {
    run.poll();
    for (int j = 0; j < steps(extent.y); ++j)
      for (int i = 0; i < steps(extent.x); ++i) {
        const Vec3 p = box.lo + h * Vec3{i + 0.5, j + 0.5, k + 0.5};
        if (!modified_.inside(p)) continue;
        for (SourceFeature& s : sources_) {
          if (!modified_.contains(s.modified, p)) continue;
          const Vec3 q = s.to_original.apply(p);
          if (original_.contains(s.original, q) && original_.inside(q)) s.volume += h * h * h;
        }
      }
  }
  std::stable_sort(
      sources_.begin(), sources_.end(),
      [](const SourceFeature& a, const SourceFeature& b) { return a.volume > b.volume; });
}

CopyPlan CopyPlan::with_new_in(const Region& region) const {
  return with_new_where([held = std::make_shared<const Region>(region)](
                            const Vec3& p, std::int32_t) { return held->holds(p); },
                        region.boxes());
}

CopyPlan CopyPlan::with_new_where(AnewTest is_anew, std::span<const Box> boxes) const {
  CopyPlan plan = *this;
  plan.anew_.push_back(std::move(is_anew));
  plan.changed_.insert(plan.changed_.end(), boxes.begin(), boxes.end());
  return plan;
}

bool CopyPlan::in_changed(const Vec3& p, double margin) const {
  return std::any_of(changed_.begin(), changed_.end(),
                     [&](const Box& box) { return box.contains(p, margin); });
}

bool CopyPlan::meets_changed(const Box& box) const {
  return std::ranges::any_of(
      changed_, [&](const Box& changed) { return !intersection(box, changed).empty(); });
}

std::vector<Box> CopyPlan::changed_within(const Box& bounds) const {
  std::vector<Box> boxes;
  for (const Box& changed : changed_) {
    Box box = intersection(changed, bounds);
    if (box.empty()) continue;
    const auto joins = [&](const Box& other) {
      Box both = box;
      both.add(other);
      return volume_of(both) <= volume_of(box) + volume_of(other);
    };
    for (auto other = std::ranges::find_if(boxes, joins); other != boxes.end();
         other = std::ranges::find_if(boxes, joins)) {
      box.add(*other);
      boxes.erase(other);
    }
    boxes.push_back(box);
  }
  return boxes;
}

std::int32_t CopyPlan::operator()(const Vec3& p) const {
  if (!modified_.inside(p)) return kOutside;
  if (!in_changed(p)) return identity_;
  const std::int32_t t = copied_by(p);
  const bool anew =
      t != kNew && std::ranges::any_of(anew_, [&](const auto& is_anew) { return is_anew(p, t); });
  return anew ? kNew : t;
}

std::int32_t CopyPlan::copied_by(const Vec3& p) const {
  for (const SourceFeature& s : sources_) {
    if (!modified_.contains(s.modified, p)) continue;
    const Vec3 q = s.to_original.apply(p);
    if (original_.contains(s.original, q) && original_.inside(q)) return s.transform;
  }
  return kNew;
}

bool CopyPlan::active_face(const Vec3& p, const Vec3& n) const {
  const std::array<Vec3, 2> side{p + probe_ * n, p - probe_ * n};
  const std::array<std::int32_t, 2> source{(*this)(side[0]), (*this)(side[1])};
  const bool inside0 = source[0] != kOutside, inside1 = source[1] != kOutside;
  if (!inside0 && !inside1) return false;
  if (inside0 && inside1 && source[0] != source[1]) return true;
  const bool boundary_now = inside0 != inside1;
  const std::int32_t t = inside0 ? source[0] : source[1];
  if (t == kNew) return false;
  const bool then0 = original_.inside(inverses_[t].apply(side[0]));
  const bool then1 = original_.inside(inverses_[t].apply(side[1]));
  return boundary_now != (then0 != then1);
}

std::string to_text(const CopyPlan& plan, const FeatureModel& original) {
  std::ostringstream out;
  out.precision(6);
  for (const SourceFeature& s : plan.sources()) {
    const Transform& t = plan.transforms()[s.transform];
    out << "copies " << original.features[s.original].id << ": volume " << s.volume;
    if (!t.is_identity()) out << ", transformation " << s.transform;
    out << (s.same_shape ? "" : ", of another shape") << '\n';
  }
  if (plan.sources().empty()) out << "copies nothing\n";
  for (const Box& box : plan.changed())
    out << "changed: " << box.lo.x << ' ' << box.lo.y << ' ' << box.lo.z << " to " << box.hi.x
        << ' ' << box.hi.y << ' ' << box.hi.z << '\n';
  return out.str();
}

}  // namespace remeshd
