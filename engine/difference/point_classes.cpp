#include "engine/difference/point_classes.h"

#include <algorithm>

#include "engine/difference/feature_difference.h"

namespace remeshd {
namespace {

Mark cell_mark(const Membership& model, int feature, const Vec3& p) {
  if (feature < 0 || !model.contains(feature, p)) return Mark::Absent;
  return model.inside(p) ? Mark::Yes : Mark::No;
}

Mark face_mark(const Membership& model, int feature, const Vec3& before, const Vec3& behind) {
  if (feature < 0) return Mark::Absent;
  if (!model.contains(feature, before) && !model.contains(feature, behind)) return Mark::Absent;
  std::vector<int> a, b;
  model.owners(before, a);
  model.owners(behind, b);
  if (a == b) return Mark::Absent;  // one cell on both sides: no face
  return model.inside(before) != model.inside(behind) ? Mark::Yes : Mark::No;
}

/// A model of the feature alone, in its alignment frame.
FeatureModel aligned(Feature feature) {
  feature.placement = rigid_inverse(feature.alignment) * feature.placement;
  feature.alignment = Transform::translation({0, 0, 0});
  return {"", {std::move(feature)}};
}

/// Whether two motions take the points of a box to the same places, but for rounding.
bool same_motion(const Transform& a, const Transform& b, const Box& box) {
  if (a == b) return true;
  const Box from_a = moved(box, a), from_b = moved(box, b);
  double gap = std::max(distance(from_a.lo, from_b.lo), distance(from_a.hi, from_b.hi));
  for (const Vec3& p : corners_of(box)) gap = std::max(gap, distance(a.apply(p), b.apply(p)));
  return gap <= 1e-12 * box.diagonal();
}

bool has_volume(const Box& box) {
  return box.lo.x < box.hi.x && box.lo.y < box.hi.y && box.lo.z < box.hi.z;
}

/// Adds a box to boxes that lie apart, joining it with those it meets.
void join(std::vector<Box>& boxes, Box box) {
  for (auto it = boxes.begin(); it != boxes.end();) {
    if (has_volume(intersection(*it, box))) {
      box.add(*it);
      boxes.erase(it);
      it = boxes.begin();
    } else {
      ++it;
    }
  }
  boxes.push_back(box);
}

}  // namespace

PointClasses::PointClasses(const FeatureModel& original, const FeatureModel& modified)
    : original_(original), modified_(modified) {
  int last_in_order = -1;
  for (int i = 0; i < static_cast<int>(modified.features.size()); ++i) {
    FeaturePair pair{modified.features[i].id, -1, i, {}, false};
    pair.original = original.index_of(pair.id);
    if (pair.original >= 0) {
      const Feature& before = original.features[pair.original];
      pair.to_original = remeshd::to_original(before, modified.features[i]);
      pair.same = pair.original > last_in_order && before.nature == modified.features[i].nature &&
                  same_geometry(aligned(before), aligned(modified.features[i]));
      last_in_order = std::max(last_in_order, pair.original);
    }
    features_.push_back(std::move(pair));
  }
  for (int i = 0; i < static_cast<int>(original.features.size()); ++i)
    if (modified.index_of(original.features[i].id) < 0)
      features_.push_back({original.features[i].id, i, -1, {}, false});
}

DifferenceClass PointClasses::cell(int feature, const Vec3& p) const {
  const FeaturePair& pair = features_[feature];
  return classify(cell_mark(original_, pair.original, pair.to_original.apply(p)),
                  cell_mark(modified_, pair.modified, p));
}

DifferenceClass PointClasses::face(int feature, const Vec3& p, const Vec3& n, double probe) const {
  const FeaturePair& pair = features_[feature];
  const Vec3 before = p + probe * n, behind = p - probe * n;
  return classify(face_mark(original_, pair.original, pair.to_original.apply(before),
                            pair.to_original.apply(behind)),
                  face_mark(modified_, pair.modified, before, behind));
}

bool PointClasses::in_copycell(const Vec3& p) const {
  if (!modified_.inside(p)) return false;
  return std::ranges::any_of(features_, [&](const FeaturePair& pair) {
    if (pair.original < 0 || pair.modified < 0 || !modified_.contains(pair.modified, p))
      return false;
    return cell_mark(original_, pair.original, pair.to_original.apply(p)) == Mark::Yes;
  });
}

bool PointClasses::in_newcell(const Vec3& p) const {
  return modified_.inside(p) && !in_copycell(p);
}

std::vector<Box> PointClasses::changed_seen_from(const Transform& to_original,
                                                 const Box& within) const {
  const Transform to_modified = rigid_inverse(to_original);
  std::vector<Box> boxes;
  const auto add = [&](const Box& box) {
    if (const Box part = intersection(box, within); has_volume(part)) join(boxes, part);
  };
  for (const FeaturePair& pair : features_) {
    if (pair.same && same_motion(pair.to_original, to_original, within)) continue;
    if (pair.modified >= 0) add(modified_.solids()[pair.modified].bounds());
    if (pair.original >= 0) add(moved(original_.solids()[pair.original].bounds(), to_modified));
  }
  return boxes;
}

std::vector<Box> PointClasses::changed(int feature) const {
  const FeaturePair& pair = features_[feature];
  Box within;
  if (pair.modified >= 0) within.add(modified_.solids()[pair.modified].bounds());
  if (pair.original >= 0)
    within.add(moved(original_.solids()[pair.original].bounds(), rigid_inverse(pair.to_original)));
  if (pair.original < 0 || pair.modified < 0) return {within};
  return changed_seen_from(pair.to_original, within);
}

std::vector<Box> PointClasses::changed() const { return changed_seen_from({}, modified_.bounds()); }

}  // namespace remeshd
