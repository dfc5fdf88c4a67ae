#include "engine/local_fuse/local_fuse.h"

#include "engine/base/error.h"
#include "engine/cellular/boundary_model/boundary_parts.h"
#include "engine/local_fuse/sewing/sew.h"
#include "engine/model/solid.h"

namespace remeshd {

CellularModel build_cells(const FeatureModel& model, const FeatureModel& base_model,
                          const CellularModel& base, const Run& run) {
  if (!base.parts) return build_cells(model, run);  // the base has no features
  run.poll();
  const Membership membership(model);
  try {
    if (auto parts = sew({model, membership}, {base_model, *base.parts}, run))
      return restore_cells(model, membership, *std::move(parts));
  } catch (const Error& failure) {
    // What is wrong with a model is told from all of it.
    if (failure.info().kind == ErrorKind::Cancelled) throw;
  }
  return build_cells(model, run);
}

}  // namespace remeshd
