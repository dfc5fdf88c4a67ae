#include "engine/delivery/unmeshed.h"

#include <string>

#include "engine/delivery/group_outcomes.h"

namespace remeshd {

Revision unmeshed(const FeatureModel& model, const Run& run) {
  Revision revision = Revision::none();
  revision.model = model;
  revision.cells = build_cells(model, run);
  const BoundaryModel& boundary = revision.cells.boundary;
  MeshGroups& groups = revision.output.groups;
  // Each name by itself: which of a face's names a facet has depends on where it lies.
  for (const BoundaryFace& face : boundary.faces)
    for (const FaceName& name : face.names)
      groups.facet_groups.push_back({model.features[name.feature].id + "." + name.face});
  for (const std::string& group : groups_of_nothing(model, boundary, run))
    groups.of_model.push_back({.name = group, .facets = {}, .tets = {}});
  revision.report.figures = groups_before_meshing(model, boundary, run);
  return revision;
}

}  // namespace remeshd
