#include <algorithm>
#include <cmath>

#include "engine/difference/compare.h"
#include "engine/difference/feature_difference.h"
#include "engine/model/solid.h"

namespace remeshd {
namespace {

/// Collects motions and keeps the smallest that is not none.
class Smallest {
 public:
  explicit Smallest(double none) : none_(none) {}
  void add(double motion) {
    if (motion > none_) value_ = std::min(value_, motion);
  }
  [[nodiscard]] double value() const { return value_; }

 private:
  double none_;
  double value_ = HUGE_VAL;
};

/// How far two motions of the same points differ: the largest distance at the corners of a box.
double difference(const Transform& a, const Transform& b, const Box& box) {
  double largest = 0;
  for (const Vec3& p : corners_of(box))
    largest = std::max(largest, distance(a.apply(p), b.apply(p)));
  return largest;
}

/// The feature in its alignment frame, in which two versions of it are compared.
Solid aligned(Feature feature) {
  feature.placement = rigid_inverse(feature.alignment) * feature.placement;
  return Solid(feature);
}

void add_changes_of_shape(const Feature& original, const Feature& modified, Smallest& smallest) {
  const Solid before = aligned(original), after = aligned(modified);
  if (before.faces().size() != after.faces().size()) return;
  for (std::size_t i = 0; i < before.faces().size(); ++i) {
    const Surface &a = before.faces()[i].surface, &b = after.faces()[i].surface;
    if (a.kind != b.kind) continue;
    smallest.add(std::fabs(a.r1 - b.r1));
    if (a.kind == Surface::Kind::Cone)
      smallest.add(std::fabs(a.r2 - b.r2) * before.bounds().diagonal());
    else
      smallest.add(std::fabs(a.r2 - b.r2));
    if (a.kind == Surface::Kind::Plane)
      smallest.add(std::fabs(signed_distance(a, b.frame.apply({}))));
    else
      smallest.add(distance(a.frame.apply({}), b.frame.apply({})));
    const Vec3 axis_a{a.frame.m[2], a.frame.m[6], a.frame.m[10]};
    const Vec3 axis_b{b.frame.m[2], b.frame.m[6], b.frame.m[10]};
    smallest.add(norm(axis_a - axis_b) * before.bounds().diagonal());
  }
}

}  // namespace

double smallest_motion(const FeatureModel& original, const FeatureModel& modified) {
  Box box;
  for (const FeatureModel* model : {&original, &modified})
    for (const Feature& feature : model->features) box.add(Solid(feature).bounds());
  Smallest smallest(1e-12 * box.diagonal());
  std::vector<Transform> motions;
  for (const Feature& feature : modified.features) {
    const int i = original.index_of(feature.id);
    if (i < 0) continue;
    add_changes_of_shape(original.features[i], feature, smallest);
    const Transform motion = to_original(original.features[i], feature);
    for (const Transform& other : motions) smallest.add(difference(motion, other, box));
    smallest.add(difference(motion, {}, box));
    if (std::ranges::find(motions, motion) == motions.end()) motions.push_back(motion);
  }
  return smallest.value();
}

}  // namespace remeshd
