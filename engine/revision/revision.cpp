#include "engine/revision/revision.h"

#include <cmath>

#include "engine/revision/delaunay_state.h"

namespace remeshd {

const Revision& Revision::none() {
  static const Revision none = [] {
    Revision revision;
    revision.edge_length = HUGE_VAL;
    revision.delaunay_state = std::make_shared<const DelaunayState>();
    return revision;
  }();
  return none;
}

const FeatureModel& Revision::delaunay_model() const {
  return anchor ? anchor->model : meshed_model;
}

const CowVector<Vec3>& Revision::delaunay_nodes() const {
  return anchor ? anchor->nodes : output.mesh.nodes;
}

bool Revision::is_copied_at_anchor() const {
  return anchor && (options.sizing.even || options.hold > 0);
}

const FeatureModel& Revision::copied_model() const {
  return is_copied_at_anchor() ? anchor->model : meshed_model;
}

const CowVector<Vec3>& Revision::copied_nodes() const {
  return is_copied_at_anchor() ? anchor->nodes : output.mesh.nodes;
}

const CowVector<Support>& Revision::supports() const {
  return anchor ? anchor->supports : delaunay_state->supports;
}

}  // namespace remeshd
