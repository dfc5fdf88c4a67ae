#include "engine/cellular/features_at.h"

#include <utility>

namespace remeshd {
namespace {

/// Whether the solid's surface passes through the ball, judged by the centre and 26 points on it:
/// some are in the solid, others not.
bool passes(const Solid& solid, const Vec3& centre, double radius) {
  const bool inside = solid.contains(centre);
  for (const double x : {-1.0, 0.0, 1.0})
    for (const double y : {-1.0, 0.0, 1.0})
      for (const double z : {-1.0, 0.0, 1.0}) {
        const Vec3 d{x, y, z};
        if (norm2(d) > 0 && solid.contains(centre + radius * normalised(d)) != inside) return true;
      }
  return false;
}

}  // namespace

FeatureIds ids_of(const FeatureModel& model, const std::vector<int>& features) {
  FeatureIds ids;
  for (const int f : features) ids.push_back(model.features[f].id);
  return ids;
}

FeatureIds features_at(const FeatureModel& model, const Membership& membership, const Vec3& place) {
  const double diagonal = membership.bounds_of_all().diagonal();
  std::vector<int> features;
  for (const double share : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
    std::vector<int> found;
    for (std::size_t f = 0; f < membership.solids().size(); ++f)
      if (passes(membership.solids()[f], place, share * diagonal))
        found.push_back(static_cast<int>(f));
    if (found.size() > features.size()) features = std::move(found);
    if (features.size() > 1) break;
  }
  return ids_of(model, features);
}

}  // namespace remeshd
