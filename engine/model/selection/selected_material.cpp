#include "engine/model/selection/selected_material.h"

#include <optional>

namespace remeshd {

namespace {
constexpr int kSteps = 40;  // points along each side of a feature's box
}

bool has_material(const SelectedFaces& on, const FeatureModel& model, const Membership& membership,
                  const Run& run) {
  if (!on.whole || model.features[on.feature].nature != Nature::Additive) return false;
  std::optional<ConditionTest> holds;
  if (!on.condition.text.empty()) holds.emplace(on.condition);
  const Box& box = membership.solids()[on.feature].bounds();
  const Vec3 step = (box.hi - box.lo) / kSteps;
  for (int k = 0; k < kSteps; ++k) {
    run.poll();
    for (int j = 0; j < kSteps; ++j)
      for (int i = 0; i < kSteps; ++i) {
        const Vec3 p = box.lo + Vec3{(i + 0.5) * step.x, (j + 0.5) * step.y, (k + 0.5) * step.z};
        if (membership.contains(on.feature, p) && membership.inside(p) &&
            (!holds || (*holds)(p, {})))
          return true;
      }
  }
  return false;
}

}  // namespace remeshd
