#include "engine/local_fuse/local_fuse.h"

#include "engine/base/error.h"
#include "engine/base/stopwatch.h"
#include "engine/local_fuse/sewing/sew.h"
#include "engine/model/solid.h"

namespace remeshd {

CellularModel build_cells(const FeatureModel& model, const FeatureModel& base_model,
                          const CellularModel& base, const Run& run) {
  if (!base.parts) return build_cells(model, run);  // the base has no features
  run.poll();
  const Membership membership(model);
  Sewn sewn = sew({model, membership}, {base_model, *base.parts}, run);
  const auto with_attempts = [&](CellularModel cells) {
    cells.geometry_attempts = std::move(sewn.given_up);
    return cells;
  };
  if (sewn.parts) {
    const std::string_view route = sewn.parts->geometry;
    const Stopwatch watch;
    try {
      return with_attempts(restore_cells(model, membership, *std::move(sewn.parts)));
    } catch (const Error& failure) {
      // Only a fuse of the whole model tells whether the model itself is at fault.
      sewn.given_up.push_back({std::string(route), failure.what(), watch.total()});
    }
  }
  return with_attempts(build_cells(model, run));
}

}  // namespace remeshd
