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

}  // namespace

PointClasses::PointClasses(const FeatureModel& original, const FeatureModel& modified)
    : original_(original), modified_(modified) {
  for (int i = 0; i < static_cast<int>(modified.features.size()); ++i) {
    FeaturePair pair{modified.features[i].id, -1, i, {}};
    pair.original = original.index_of(pair.id);
    if (pair.original >= 0)
      pair.to_original =
          remeshd::to_original(original.features[pair.original], modified.features[i]);
    features_.push_back(std::move(pair));
  }
  for (int i = 0; i < static_cast<int>(original.features.size()); ++i)
    if (modified.index_of(original.features[i].id) < 0)
      features_.push_back({original.features[i].id, i, -1, {}});
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

}  // namespace remeshd
